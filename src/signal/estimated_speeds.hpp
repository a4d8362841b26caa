#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "signal/description.hpp"
#include "signal/ingest.hpp"

namespace piae::signal {

/// Returns the longest piece of a signal in several pieces of these lengths.
std::span<const double> longest_piece(std::span<const double> signal,
                                      const std::vector<std::size_t>& lengths);

/// Result of use_speeds_of_signals().
struct EstimatedSpeeds {
  std::size_t found = 0;  ///< records whose shaft shows its speed
  double lowest = 1;      ///< least and greatest estimate over the given speed
  double highest = 1;
};

/// True if use_speeds_of_signals() reads the record.
bool reads_for_speed(const Description& description, const RecordSource& source);

/// Replaces the speed of each record by the mean of its speed over time, if that was recorded
/// (measured_speed.hpp), or else by the one that its signal shows (spectra/shaft_speed.hpp), within
/// speed_search_percent of the given one; keeps the given one where the shaft hardly shows, and if
/// speed_search_percent is 0. The speed of a condition becomes the mean of its records. Throws as
/// RecordReader does.
EstimatedSpeeds use_speeds_of_signals(Description& description,
                                      const std::filesystem::path& data_dir,
                                      const std::function<void()>& record_done);

}  // namespace piae::signal

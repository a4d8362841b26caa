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

/// Replaces the speed of each record by the one that its signal shows (spectra/shaft_speed.hpp),
/// within speed_search_percent of the given one; keeps the given one where the shaft hardly shows.
/// The speed of a condition becomes the mean of its records. Does not read anything if
/// speed_search_percent is 0. Throws as RecordReader does.
EstimatedSpeeds use_speeds_of_signals(Description& description,
                                      const std::filesystem::path& data_dir,
                                      const std::function<void()>& record_done);

}  // namespace piae::signal

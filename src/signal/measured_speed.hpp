#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "signal/speed_course.hpp"
#include "signal/speed_source.hpp"

namespace piae::signal {

/// A record whose speed over time is to be read.
struct RecordTimes {
  std::string name;
  std::vector<std::filesystem::path> files = {};  ///< its own
  std::vector<double> piece_s = {};               ///< durations of the signals of these files
  double sample_s = 0;                            ///< time between two samples of the signal
};

/// Reads the speed of a record over its time. Throws Error(input_missing) for a missing file.
/// Throws Error(bad_input), with the file and the record, as raw::read() does, and for
///   - a speed that is not in its range, such as 0,
///   - times of pulses that do not increase, are fewer than three, begin or end more than two
///     pulses within the record, or lack a pulse: a step of more than 1.5 times its neighbour,
///   - pulses of a record in several files.
SpeedCourse read_speed(const SpeedSource& source, const std::filesystem::path& data_dir,
                       const RecordTimes& record);

/// Returns the angle of a shaft from the times of its pulses. `where` starts the messages.
ShaftAngle angle_of_pulses(std::span<const double> times_s, double pulses_per_turn,
                           double duration_s, const std::string& where);

}  // namespace piae::signal

#pragma once

#include <cstddef>
#include <vector>

namespace piae::signal {

/// Speed of a shaft over the time of a recording: its means over successive blocks of equal length.
struct SpeedCourse {
  double block_s = 0;
  std::vector<double> rpm;  ///< not empty; the recording may end within the last block

  /// Returns the mean speed from one time to a later one, in s from the start of the recording.
  /// Beyond either end, the nearest block counts.
  [[nodiscard]] double mean_rpm(double from_s, double to_s) const;
  /// Returns the mean speed over `count` samples from `first` on, at this sample rate.
  [[nodiscard]] double mean_rpm(std::size_t first, std::size_t count, double rate_hz) const;
};

/// Turns of a shaft since any start at ascending times, two or more. Between them, the shaft turns
/// evenly.
struct ShaftAngle {
  std::vector<double> time_s;
  std::vector<double> turns;
};

/// Returns the speed in blocks of 20 ms, or of `least_block_s` if that is longer, up to the end of
/// the recording. Before the first time and after the last one, the shaft turns as next to it.
SpeedCourse speed_course(const ShaftAngle& angle, double duration_s, double least_block_s);

}  // namespace piae::signal

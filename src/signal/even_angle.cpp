#include "signal/even_angle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace piae::signal {

namespace {

/// Interpolates between two samples; returns the last sample beyond the end.
double at(std::span<const double> signal, double place) {
  const double inside = std::clamp(place, 0.0, static_cast<double>(signal.size() - 1));
  const std::size_t before = std::min(static_cast<std::size_t>(inside), signal.size() - 2);
  return std::lerp(signal[before], signal[before + 1], inside - static_cast<double>(before));
}

}  // namespace

std::vector<double> at_even_angle(std::span<const double> signal, double rate_hz,
                                  const SpeedCourse& speeds) {
  if (signal.size() < 2) return {signal.begin(), signal.end()};
  const auto samples = static_cast<double>(signal.size());
  const double mean_rpm = speeds.mean_rpm(0, samples / rate_hz);
  std::vector<double> even;
  even.reserve(signal.size());
  std::size_t block = 0;
  double start = 0;  // of the block, in samples at the mean speed
  for (double i = 0; i < samples; ++i) {
    double length = speeds.block_s * rate_hz * speeds.rpm[block] / mean_rpm;
    while (start + length <= i && block + 1 < speeds.rpm.size()) {
      start += length;
      length = speeds.block_s * rate_hz * speeds.rpm[++block] / mean_rpm;
    }
    const double since = (i - start) * mean_rpm / speeds.rpm[block];
    even.push_back(at(signal, static_cast<double>(block) * speeds.block_s * rate_hz + since));
  }
  return even;
}

}  // namespace piae::signal

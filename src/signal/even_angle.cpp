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
  const double mean_rpm = speeds.mean_rpm(std::size_t{0}, signal.size(), rate_hz);
  const double block_samples = speeds.block_s * rate_hz;
  std::vector<double> even(signal.size());
  std::size_t block = 0;
  double start = 0;  // of the block, in samples at the mean speed
  for (std::size_t i = 0; i < even.size(); ++i) {
    const auto place = static_cast<double>(i);
    double length = block_samples * speeds.rpm[block] / mean_rpm;
    while (start + length <= place && block + 1 < speeds.rpm.size()) {
      start += length;
      length = block_samples * speeds.rpm[++block] / mean_rpm;
    }
    const double since = (place - start) * mean_rpm / speeds.rpm[block];
    even[i] = at(signal, static_cast<double>(block) * block_samples + since);
  }
  return even;
}

}  // namespace piae::signal

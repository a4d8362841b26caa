#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace piae {

/// Returns noise of deviation 1 with twelve harmonics of a shaft's speed, each 0.05 high, which is
/// 29 dB less power.
inline std::vector<double> turning_shaft(double rpm, std::size_t samples, double rate_hz,
                                         unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> signal(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const double turn = 2 * std::numbers::pi * rpm / 60 * static_cast<double>(i) / rate_hz;
    signal[i] = normal(random);
    for (int n = 1; n <= 12; ++n) signal[i] += 0.05 * std::sin(n * turn + n * n);
  }
  return signal;
}

/// Returns a text with a sample a line.
inline std::string column_of(const std::vector<double>& samples) {
  std::string text;
  for (const double sample : samples) text += std::to_string(sample) + '\n';
  return text;
}

}  // namespace piae

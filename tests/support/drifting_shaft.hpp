#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace piae {

/// A shaft that turns `drift` faster at the end than at the start, evenly accelerated about a mean
/// speed.
struct DriftingShaft {
  double mean_rpm = 1500;
  double drift = 0.2;  ///< relative to the mean
  double duration_s = 20;

  [[nodiscard]] double rpm_at(double time_s) const {
    return mean_rpm * (1 + drift * (time_s / duration_s - 0.5));
  }
  /// Returns the time of an angle: the root of turns = a t + b t^2.
  [[nodiscard]] double time_s(double turns) const {
    const double a = rpm_at(0) / 60;
    const double b = mean_rpm / 60 * drift / (2 * duration_s);
    return b == 0 ? turns / a : (std::sqrt(a * a + 4 * b * turns) - a) / (2 * b);
  }
  /// Returns the times of events at this order of the shaft, from 0 to the end.
  [[nodiscard]] std::vector<double> times_s(double order) const {
    std::vector<double> times;
    for (int k = 0; time_s(k / order) < duration_s; ++k) times.push_back(time_s(k / order));
    return times;
  }
  /// Returns noise with impacts at this order, each a decaying oscillation at 3 kHz.
  [[nodiscard]] std::vector<double> impacts(double order, double height, double rate_hz,
                                            unsigned seed) const {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> signal(static_cast<std::size_t>(duration_s * rate_hz));
    for (double& sample : signal) sample = normal(random);
    for (const double start_s : times_s(order)) {
      const auto first = static_cast<std::size_t>(std::ceil(start_s * rate_hz));
      for (std::size_t i = first; i < std::min(first + 60, signal.size()); ++i) {
        const double after_s = static_cast<double>(i) / rate_hz - start_s;
        signal[i] +=
            height * std::exp(-800 * after_s) * std::sin(2 * std::numbers::pi * 3000 * after_s);
      }
    }
    return signal;
  }
};

}  // namespace piae

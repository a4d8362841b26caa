#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "machines/machine.hpp"
#include "signal/window_set.hpp"

namespace piae::machines {

/// Returns a machine with a 6205 at 1800 rpm and 12 kHz, without anything but white noise.
inline Machine plain_machine() {
  Machine machine;
  machine.info.name = "plain";
  machine.info.sample_rate_hz = 12000;
  machine.info.shaft_speed_rpm = 1800;
  machine.info.classes = {{.name = "healthy", .defect = signal::Defect::none},
                          {.name = "inner", .defect = signal::Defect::inner},
                          {.name = "ball", .defect = signal::Defect::roller},
                          {.name = "outer", .defect = signal::Defect::outer}};
  machine.log_amplitude = Eigen::ArrayXd::Zero(4097);
  return machine;
}

/// Returns the mean square of a window.
inline double power_of(const signal::WindowSet& set, std::size_t i) {
  double sum = 0;
  for (const float sample : set.window(i)) sum += static_cast<double>(sample) * sample;
  return sum / static_cast<double>(set.length);
}

/// Returns the amplitude of a sine of this frequency in a window, by its Fourier sum under Hann's
/// window.
inline double sine_in(const signal::WindowSet& set, std::size_t i, double hz,
                      bool squared = false) {
  double real = 0;
  double imaginary = 0;
  double weight = 0;
  double mean = 0;
  const auto n = static_cast<double>(set.length);
  const auto value = [&](std::size_t t) {
    const double sample = set.window(i)[t];
    return squared ? sample * sample : sample;
  };
  for (std::size_t t = 0; t < set.length; ++t) mean += value(t) / n;
  for (std::size_t t = 0; t < set.length; ++t) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(t);
    const double hann = 0.5 - 0.5 * std::cos(turn / n);
    const double phase = turn * hz / set.info.sample_rate_hz;
    real += hann * (value(t) - mean) * std::cos(phase);
    imaginary += hann * (value(t) - mean) * std::sin(phase);
    weight += hann;
  }
  return 2 * std::hypot(real, imaginary) / weight;
}

}  // namespace piae::machines

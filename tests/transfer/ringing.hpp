#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace piae::transfer {

/// Returns a resonance of 3 kHz at 12 kHz, excited at first, first + period and so on, that decays
/// within about 40 samples.
inline std::vector<double> ringing(double first, double period, std::size_t length) {
  std::vector<double> window(length, 0.0);
  for (double strike = first; strike < static_cast<double>(length); strike += period) {
    for (auto t = static_cast<std::size_t>(std::ceil(strike)); t < length; ++t) {
      const double since = static_cast<double>(t) - strike;
      window[t] += std::exp(-since / 15) * std::sin(2 * std::numbers::pi * 0.25 * since);
    }
  }
  return window;
}

}  // namespace piae::transfer

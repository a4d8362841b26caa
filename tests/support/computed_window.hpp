#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace piae {

/// Returns a window of 2048 samples at 12 kHz that any program can reproduce: noise by Knuth's
/// linear congruential generator (MMIX, from 1), and impacts on a 3 kHz resonance at 1.004 times a
/// 6205's BPFO at 1800 rpm. The expected values of tests come from another author's implementation
/// of the same equations in float64 with numpy 1.24: np.fft.rfft, np.convolve, np.median over
/// sliding windows, np.interp, np.bincount.
inline std::vector<float> computed_window() {
  constexpr double rate_hz = 12000;
  const double impacts_hz = 4.5 * (1 - 7.94 / 39) * 30 * 1.004;
  std::uint64_t state = 1;
  std::vector<float> window;
  for (std::size_t t = 0; t < 2048; ++t) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    double sample = static_cast<double>(state >> 11U) / 9007199254740992.0 - 0.5;
    for (int strike = 0; strike < 60; ++strike) {
      const double since_s = static_cast<double>(t) / rate_hz - (strike + 0.3) / impacts_hz;
      if (since_s < 0) break;
      sample += 3 * std::exp(-800 * since_s) * std::sin(2 * std::numbers::pi * 3000 * since_s);
    }
    window.push_back(static_cast<float>(sample));
  }
  return window;
}

}  // namespace piae

#pragma once

#include <cmath>
#include <numbers>

#include "spectra/power.hpp"

namespace piae {

/// Returns a window with whole cycles of a cosine.
inline spectra::Windows tone(Eigen::Index length, double amplitude, int cycles, double phase) {
  spectra::Windows window(1, length);
  for (Eigen::Index i = 0; i < length; ++i) {
    window(0, i) = amplitude * std::cos(2 * std::numbers::pi * cycles * static_cast<double>(i) /
                                            static_cast<double>(length) +
                                        phase);
  }
  return window;
}

}  // namespace piae

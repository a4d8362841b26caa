#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.hpp"

namespace piae {

/// A resonance at a quarter of the rate that is struck `strikes_hz` times a second (never for 0),
/// in normal noise of a tenth of the strikes' height.
inline std::vector<double> struck_recording(double rate_hz, double seconds, double strikes_hz,
                                            const std::string& name) {
  Stream noise(name);
  std::vector<double> samples(static_cast<std::size_t>(rate_hz * seconds));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i] = noise.normal(0, 0.1);
    if (strikes_hz == 0) continue;
    const double since = std::fmod(static_cast<double>(i) / rate_hz, 1 / strikes_hz) * rate_hz;
    samples[i] += std::exp(-since / 12) * std::sin(std::numbers::pi / 2 * since);
  }
  return samples;
}

}  // namespace piae

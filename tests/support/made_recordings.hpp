#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.hpp"

namespace piae {

/// Returns a resonance at a quarter of the rate, with `impacts_hz` impacts a second (0 for none),
/// in normal noise of a tenth of the impacts' height.
inline std::vector<double> impact_recording(double rate_hz, double seconds, double impacts_hz,
                                            const std::string& name) {
  Stream noise(name);
  std::vector<double> samples(static_cast<std::size_t>(rate_hz * seconds));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i] = noise.normal(0, 0.1);
    if (impacts_hz == 0) continue;
    const double since = std::fmod(static_cast<double>(i) / rate_hz, 1 / impacts_hz) * rate_hz;
    samples[i] += std::exp(-since / 12) * std::sin(std::numbers::pi / 2 * since);
  }
  return samples;
}

}  // namespace piae

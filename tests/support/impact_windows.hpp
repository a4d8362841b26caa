#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "signal/window_set.hpp"
#include "support/three_classes.hpp"

namespace piae {

/// Settings of impact_window().
struct Impacting {
  std::size_t length = 4096;
  double rate_hz = 12000;
  double impacts_hz = 0;  ///< impacts a second on a resonance of 3 kHz; 0 for none
  double level = 10;      ///< height of an impact, in standard deviations of the noise
};

/// Returns white noise, and a resonance with regular impacts, from a random moment on.
inline std::vector<float> impact_window(const Impacting& made, Stream& stream) {
  std::vector<double> samples(made.length);
  for (double& sample : samples) sample = stream.normal(0, 1);
  const double duration_s = static_cast<double>(made.length) / made.rate_hz;
  const double first = stream.uniform(0, 1);
  for (int strike = 0; made.impacts_hz > 0 && strike < duration_s * made.impacts_hz; ++strike) {
    for (std::size_t t = 0; t < made.length; ++t) {
      const double since_s =
          static_cast<double>(t) / made.rate_hz - (strike + first) / made.impacts_hz;
      if (since_s < 0) continue;
      samples[t] +=
          made.level * std::exp(-800 * since_s) * std::sin(2 * std::numbers::pi * 3000 * since_s);
    }
  }
  return {samples.begin(), samples.end()};
}

/// Returns an empty set of such windows for a 6205 at 1800 rpm: healthy, inner, outer.
inline signal::WindowSet no_impact_windows(std::size_t length = 4096) {
  signal::WindowSet set;
  set.info = three_classes();
  set.length = length;
  return set;
}

/// Impact rate of each class of that set, in Hz: n/2 (1 +- d/D) times 30 Hz.
inline const std::vector<double> impacts_of_classes_hz{0, 4.5 * (1 + 7.94 / 39) * 30,
                                                       4.5 * (1 - 7.94 / 39) * 30};

/// Adds `count` windows of a class.
inline void add_impact_windows(signal::WindowSet& set, Label label, int count, Stream& stream,
                               double level = 10) {
  for (int i = 0; i < count; ++i) {
    const std::vector<float> window =
        impact_window({.length = set.length,
                       .impacts_hz = impacts_of_classes_hz[index_of(label)],
                       .level = level},
                      stream);
    set.samples.insert(set.samples.end(), window.begin(), window.end());
    set.labels.push_back(label);
  }
}

}  // namespace piae

#pragma once

#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "signal/window_set.hpp"
#include "support/three_classes.hpp"

namespace piae {

/// Returns a small set of known windows: three classes, five windows of each of the two fault
/// classes, decaying oscillations of different frequency at random phase, with an offset that the
/// twin must remove.
inline signal::WindowSet known_windows(std::size_t length = 64) {
  signal::WindowSet windows;
  windows.info = three_classes("example");
  windows.info.shaft_speed_rpm = 1797;
  windows.length = length;
  Stream stream("known windows");
  for (int label = 1; label <= 2; ++label) {
    for (int i = 0; i < 5; ++i) {
      const double phase = stream.uniform(0, 2 * std::numbers::pi);
      for (std::size_t t = 0; t < length; ++t) {
        windows.samples.push_back(static_cast<float>(
            0.5 + label * std::sin(0.3 * label * static_cast<double>(t) + phase)));
      }
      windows.labels.push_back(label);
    }
  }
  return windows;
}

}  // namespace piae

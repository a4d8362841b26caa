#pragma once

#include <cmath>
#include <span>

#include "base/random.hpp"
#include "signal/window_set.hpp"
#include "support/three_classes.hpp"
#include "zero/machine.hpp"

namespace piae::zero {

/// Returns healthy windows of a machine with a 6205 at 1800 rpm: noise of different levels, with an
/// offset. Its classes are healthy, inner race, outer race and ball.
inline signal::WindowSet healthy_windows(std::size_t length = 1024, std::size_t count = 6) {
  signal::WindowSet windows;
  windows.info = three_classes("zero");
  windows.info.classes.push_back({"B", signal::Defect::roller, 0.2});
  windows.length = length;
  Stream random("healthy windows");
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t t = 0; t < length; ++t) {
      windows.samples.push_back(
          static_cast<float>(0.5 + random.normal(0, 1 + static_cast<double>(i))));
    }
    windows.labels.push_back(0);
  }
  return windows;
}

/// Returns a scene on one of these windows, with a defect of this kind, at 1800 rpm.
inline Scene scene_of(const signal::WindowSet& healthy, bearing::Defect defect) {
  const Machine machine(healthy);
  Stream random("scene");
  for (const Label label : healthy.info.fault_labels()) {
    if (healthy.info.class_of(label).defect == defect) return machine.draw_scene(label, 0, random);
  }
  return {};
}

/// Returns the standard deviation of a window.
inline double deviation_of(std::span<const float> window) {
  double sum = 0;
  double squares = 0;
  for (const float x : window) {
    sum += x;
    squares += static_cast<double>(x) * x;
  }
  const auto n = static_cast<double>(window.size());
  return std::sqrt(squares / n - sum / n * (sum / n));
}

}  // namespace piae::zero

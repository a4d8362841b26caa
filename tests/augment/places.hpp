#pragma once

#include <utility>
#include <vector>

#include "support/known_windows.hpp"

namespace piae::augment {

/// Returns windows that differ in the first of two samples only, each given by its label and that
/// sample, so that distances are worked by hand.
inline signal::WindowSet at_places(const std::vector<std::pair<Label, float>>& places) {
  signal::WindowSet windows;
  windows.info = known_windows().info;
  windows.length = 2;
  for (const auto& [label, place] : places) {
    windows.labels.push_back(label);
    windows.samples.insert(windows.samples.end(), {place, 0.5F});
  }
  return windows;
}

/// Returns four windows of class IR and two of OR; healthy windows lie in between.
inline signal::WindowSet known_at_places() {
  return at_places({{1, 0}, {1, 1}, {1, 3}, {1, 9}, {2, 4}, {2, 10}});
}

inline signal::WindowSet healthy_at_places() { return at_places({{0, 5}, {0, 11}}); }

}  // namespace piae::augment

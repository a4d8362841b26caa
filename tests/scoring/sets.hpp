#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "scoring/windows.hpp"
#include "signal/window_set.hpp"

namespace piae::scoring {

/// Returns windows of normally distributed samples.
inline Windows noise(std::size_t count, std::size_t length, const std::string& name) {
  Stream stream(name);
  Windows windows(count, length);
  for (double& sample : windows.reshaped()) sample = stream.normal(0, 1);
  return windows;
}

inline void add(signal::WindowSet& set, int label, const std::vector<float>& window) {
  set.length = window.size();
  set.samples.insert(set.samples.end(), window.begin(), window.end());
  set.labels.push_back(label);
}

}  // namespace piae::scoring

#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "base/random.hpp"
#include "diagnosis/standardise.hpp"
#include "signal/window_set.hpp"
#include "support/three_classes.hpp"

namespace piae::diagnosis {

inline signal::WindowSet empty_set(std::size_t length) {
  signal::WindowSet set;
  set.info = three_classes();
  set.length = length;
  return set;
}

/// Adds distinguishable windows: the i-th of a label holds first + i, and the label at the end.
inline void add(signal::WindowSet& set, int label, std::size_t count, float first) {
  for (std::size_t i = 0; i < count; ++i) {
    set.samples.insert(set.samples.end(), set.length, static_cast<float>(label));
    set.samples[set.samples.size() - set.length] = first + static_cast<float>(i);
    set.labels.push_back(label);
  }
}

/// Makes windows of 1024 samples whose frequency is their class, with random phase and some noise:
/// any classifier of vibrations must be able to learn them.
inline LabelledWindows tones(std::size_t per_class, const std::string& stream_name) {
  Stream stream(stream_name);
  LabelledWindows set;
  set.length = 1024;
  set.classes = 3;
  for (std::size_t i = 0; i < 3 * per_class; ++i) {
    const auto label = static_cast<std::int32_t>(i % set.classes);
    const double cycles = 20.0 * (label + 1);
    const double phase = stream.uniform(0, 2 * std::numbers::pi);
    for (std::size_t t = 0; t < set.length; ++t) {
      const double angle = 2 * std::numbers::pi * cycles * static_cast<double>(t) / 1024 + phase;
      set.samples.push_back(static_cast<float>(std::sin(angle) + stream.normal(0, 0.3)));
    }
    set.labels.push_back(label);
  }
  return set;
}

}  // namespace piae::diagnosis

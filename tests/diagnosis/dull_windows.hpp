#pragma once

#include "base/random.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Adds a window of noise with its own spectrum: x[t] = n[t] + dull n[t - 1].
inline void add_dull(signal::WindowSet& set, Label label, double dull, Stream& stream) {
  double last = 0;
  for (std::size_t t = 0; t < set.length; ++t) {
    const double next = stream.normal(0, 1);
    set.samples.push_back(static_cast<float>(next + dull * last));
    last = next;
  }
  set.labels.push_back(label);
}

}  // namespace piae::diagnosis

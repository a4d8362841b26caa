#pragma once

#include "base/random.hpp"
#include "signal/window_set.hpp"

namespace piae::bench {

/// Returns windows like C of CWRU: 45 known windows of 1024 samples, 9 fault classes.
inline signal::WindowSet known_windows() {
  signal::WindowSet set;
  set.info.name = "bench";
  set.info.sample_rate_hz = 12000;
  set.info.shaft_speed_rpm = 1797;
  set.info.classes.push_back({"Normal", signal::Defect::none, 0});
  set.length = 1024;
  Stream stream("bench/known windows");
  for (std::int32_t label = 1; label <= 9; ++label) {
    set.info.classes.push_back({"fault" + std::to_string(label), signal::Defect::inner, 0.2});
    set.labels.insert(set.labels.end(), 5, label);
  }
  set.samples.resize(set.size() * set.length);
  for (float& sample : set.samples) sample = static_cast<float>(stream.normal(0, 1));
  return set;
}

}  // namespace piae::bench

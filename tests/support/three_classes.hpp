#pragma once

#include <string>

#include "signal/dataset_info.hpp"

namespace piae {

/// Returns a data set of three classes, the first of them healthy.
inline signal::DatasetInfo three_classes(const std::string& name = "toy") {
  signal::DatasetInfo info;
  info.name = name;
  info.sample_rate_hz = 12000;
  info.shaft_speed_rpm = 1800;
  info.classes = {{"Normal", signal::Defect::none, 0},
                  {"IR", signal::Defect::inner, 0.2},
                  {"OR", signal::Defect::outer, 0.2}};
  return info;
}

}  // namespace piae

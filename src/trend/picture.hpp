#pragma once

#include <string>
#include <vector>

#include "trend/trend_point.hpp"

namespace piae::trend {

/// Content of the picture of a trend.
struct Shown {
  std::string machine = {};              ///< record or stream
  std::vector<std::string> names = {};   ///< of the watched features
  std::vector<double> limits_db = {};    ///< of the watched features
  std::vector<TrendPoint> healthy = {};  ///< points of the healthy hours; empty for a kept baseline
  std::vector<TrendPoint> points = {};   ///< later points, in order of time
};

/// Draws a trend (SVG): levels, fault lines if known, novelty and evidence over time. Each panel
/// has its threshold dashed, the healthy hours shaded green, and the time of an alarm red.
std::string picture_of(const Shown& shown);

}  // namespace piae::trend

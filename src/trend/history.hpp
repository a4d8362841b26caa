#pragma once

#include <cstddef>
#include <vector>

#include "trend/trend_point.hpp"

namespace piae::trend {

/// Keeps the points of a trend for its picture. Merges neighbours when they become too many, so
/// that months need no more memory than an hour.
class History {
 public:
  explicit History(std::size_t most_points = 4096) : most_points_(most_points) {}

  void add(const TrendPoint& point);
  [[nodiscard]] const std::vector<TrendPoint>& points() const { return points_; }

 private:
  void merge_neighbours();

  std::size_t most_points_;
  std::vector<TrendPoint> points_;
};

}  // namespace piae::trend

#include "trend/history.hpp"

#include <algorithm>

namespace piae::trend {

namespace {

using monitor::AlarmState;

bool is_change(const TrendPoint& point) {
  return point.alarm == AlarmState::raised || point.alarm == AlarmState::cleared;
}

/// Returns both as one point, with the mean rises and the highest evidence.
TrendPoint merged(const TrendPoint& first, const TrendPoint& second) {
  TrendPoint both = second;
  both.windows = first.windows + second.windows;
  both.evidence = std::max(first.evidence, second.evidence);
  if (!both.rises) both.rises = first.rises;
  if (first.rises && second.rises) {
    both.rises->level_db = (first.rises->level_db + second.rises->level_db) / 2;
    both.rises->watched_db = (first.rises->watched_db + second.rises->watched_db) / 2;
    both.rises->novelty = (first.rises->novelty + second.rises->novelty) / 2;
  }
  return both;
}

}  // namespace

void History::add(const TrendPoint& point) {
  points_.push_back(point);
  if (points_.size() >= most_points_) merge_neighbours();
}

/// Keeps points at which an alarm was raised or cleared as they are.
void History::merge_neighbours() {
  std::vector<TrendPoint> fewer;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const bool has_next = i + 1 < points_.size();
    if (!has_next || is_change(points_[i]) || is_change(points_[i + 1])) {
      fewer.push_back(points_[i]);
    } else {
      fewer.push_back(merged(points_[i], points_[i + 1]));
      ++i;
    }
  }
  points_ = std::move(fewer);
}

}  // namespace piae::trend

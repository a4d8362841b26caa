#pragma once

#include <cstdint>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Parts of a training set (training_set.hpp).
struct Lessons {
  const signal::WindowSet& normal;     ///< B
  const signal::WindowSet& known;      ///< C
  const signal::WindowSet* generated;  ///< E; null if there is none
  std::int64_t generated_per_class = 0;
};

/// Folds of a training set: windows are left out of a training, so that the classifier can be
/// tested on windows it has not seen, without using any test window.
struct Folds {
  static constexpr std::int32_t count = 5;
  static constexpr std::int32_t none = -1;

  /// [n] for each training window: the fold that leaves it out and predicts it; `none` for a window
  /// that is never predicted. Healthy windows are cut into blocks of time; the known windows of a
  /// class are dealt out in turn. Generated windows are predicted only if no fault window is known;
  /// they are dealt out in turn, too.
  std::vector<std::int32_t> tested;
  /// [n][count] folds that must not train on this window: its own fold, and for a generated window
  /// the folds of its parents, because it resembles them. Without recorded parents, it is in all
  /// trainings.
  std::vector<std::vector<bool>> left_out;

  /// True if each training still has windows of every class, and enough healthy windows for a
  /// comparison (symptoms/baseline.hpp).
  bool possible = false;
};

/// Returns [n] the block of time of each healthy window; all `count` blocks have equal size.
std::vector<std::int32_t> blocks_of_time(const signal::WindowSet& normal);

/// Returns the folds of the training set that compose_training_set() makes of `lessons`.
Folds folds_of(const signal::WindowSet& training, const Lessons& lessons);

}  // namespace piae::diagnosis

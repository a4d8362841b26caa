#pragma once

#include <cstdint>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// What a training set is made of (training_set.hpp).
struct Lessons {
  const signal::WindowSet& normal;     ///< B
  const signal::WindowSet& known;      ///< C
  const signal::WindowSet* generated;  ///< E; null where there is none
  std::int64_t generated_per_class = 0;
};

/// How a training set is cut so that windows can be left out of a training, and a classifier be
/// asked about windows that it has not seen, without taking any from those that are tested.
struct Folds {
  static constexpr std::int32_t count = 5;
  static constexpr std::int32_t none = -1;

  /// [n] of each training window: in which fold it is left out and asked about; none for one that
  /// is never asked about. Healthy windows are cut into blocks of the time, and the known ones of a
  /// class are dealt out in turn. A generated one is asked about only where no window is known,
  /// dealt out in turn, too.
  std::vector<std::int32_t> asked;
  /// [n][count] in which folds it must not be trained on: its own, and of a generated window those
  /// of its parents, which it might give away. One that does not say its parents is trained on in
  /// all.
  std::vector<std::vector<bool>> left_out;

  /// Whether every class is left in each training, so that a classifier can learn it, and of
  /// healthy windows as many as others can be compared with (symptoms/baseline.hpp).
  bool possible = false;
};

/// [n] the block of the time that each healthy window is in, of `count` of equal size.
std::vector<std::int32_t> blocks_of_time(const signal::WindowSet& normal);

/// Of the training set that compose_training_set() makes of these.
Folds folds_of(const signal::WindowSet& training, const Lessons& lessons);

}  // namespace piae::diagnosis

#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/label.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/folds.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Output of classifiers for windows that they were not trained on.
struct LeftOut {
  std::vector<float> logits;  ///< row-major [n, classes]
  std::vector<Label> labels;  ///< [n]
};

/// Trains a classifier for fold `fold` on all of `training`; `normal` are its first windows, the
/// healthy ones.
using TrainFold = std::function<std::unique_ptr<Trained>(
    const signal::WindowSet& normal, const signal::WindowSet& training, std::int32_t fold)>;

/// Trains a classifier for each fold, without the windows left out there, and predicts the windows
/// of that fold.
LeftOut judge_left_out(const signal::WindowSet& training, const Folds& folds,
                       const TrainFold& train);

}  // namespace piae::diagnosis

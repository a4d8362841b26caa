#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/label.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/folds.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// What classifiers said of windows that they were not trained on.
struct LeftOut {
  std::vector<float> logits;  ///< row-major [n, classes]
  std::vector<Label> labels;  ///< [n]
};

/// Trains a classifier on healthy windows `normal` and all of `training`, in which these are the
/// first, for fold `fold`.
using TrainFold = std::function<std::unique_ptr<Trained>(
    const signal::WindowSet& normal, const signal::WindowSet& training, std::int32_t fold)>;

/// Trains it once for each fold, without what is left out there, and asks it about the windows of
/// that fold.
LeftOut ask_left_out(const signal::WindowSet& training, const Folds& folds, const TrainFold& train);

}  // namespace piae::diagnosis

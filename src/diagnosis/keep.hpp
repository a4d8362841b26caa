#pragma once

#include <functional>
#include <memory>

#include "base/random.hpp"
#include "diagnosis/folds.hpp"
#include "diagnosis/kept_classifier.hpp"
#include "diagnosis/learning_settings.hpp"

namespace piae::diagnosis {

/// Settings for retraining a classifier without the left-out windows.
struct Relearn {
  const LearningSettings& settings;
  const Stream& stream;  ///< stream of the classifier; fold k draws from its child "left-out<k>"
  EpochDone epoch_done;  ///< called after each epoch of these trainings
};

/// Returns how often keep() retrains the classifier: once for each fold, or 0 if folds are not
/// possible.
std::int64_t trainings_to_keep(const signal::WindowSet& training, const Lessons& lessons);

/// Prepares a trained classifier for keeping. Its temperature is the best one for windows that were
/// left out of trainings of their own (folds.hpp). If folds are not possible, for example because a
/// class has only one known window, the temperature is 1. The real windows of the training set are
/// the reference of the novelty. If no fault is known in the tested condition, novelty is
/// unavailable, because every real fault would be novel.
KeptClassifier keep(const Classifier& classifier, std::unique_ptr<Trained> trained,
                    const signal::WindowSet& training, const Lessons& lessons,
                    const Relearn& relearn, ClassifierOrigin origin);

}  // namespace piae::diagnosis

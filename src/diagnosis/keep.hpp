#pragma once

#include <functional>
#include <memory>

#include "base/random.hpp"
#include "diagnosis/folds.hpp"
#include "diagnosis/kept_classifier.hpp"
#include "diagnosis/wdcnn_backend.hpp"

namespace piae::diagnosis {

/// How classifiers of the same kind are trained once more, without what is left out.
struct Relearn {
  const WdcnnOptions& options;
  const Stream& stream;  ///< that of the classifier; fold k draws from its child "left-out<k>"
  const MakeWdcnnBackend& make_backend;
  EpochDone epoch_done;  ///< of each of these trainings
};

/// How often keep() trains a classifier of that kind again: once for each fold, or never where none
/// can be left out.
std::int64_t trainings_to_keep(const signal::WindowSet& training, const Lessons& lessons);

/// Makes a trained classifier ready to be kept. Its temperature is the best one for windows that
/// were left out of trainings of their own (folds.hpp); where these cannot be, as where a class has
/// one known window alone, it is 1. Strangeness has for reference the real windows of the training
/// set. There is none where no fault is known in the tested condition: then a real fault is as
/// strange as any other.
KeptClassifier keep(const Classifier& classifier, std::unique_ptr<Trained> trained,
                    const signal::WindowSet& training, const Lessons& lessons,
                    const Relearn& relearn, ClassifierOrigin origin);

}  // namespace piae::diagnosis

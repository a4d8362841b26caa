#pragma once

#include "diagnosis/catalogue.hpp"
#include "diagnosis/wdcnn.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// What a classifier that has the training windows says of the test windows. `normal` is B as
/// `split` made it: generated windows beside them in `training` are silent on their place, and then
/// no window of that set says it. Of a classifier that is not trained there are the predictions and
/// the scores alone; `options` and `make_backend` are for WDCNN. Random numbers come from `stream`,
/// or, of another classifier than the paper's, from its child of that name. Throws as
/// train_and_test(), classify_by_nearest(), classify_by_rule() and train_and_test_symptoms() do.
WdcnnResult classify(const Classifier& classifier, const signal::WindowSet& normal,
                     const signal::WindowSet& training, const signal::WindowSet& test,
                     const WdcnnOptions& options, const Stream& stream,
                     const MakeWdcnnBackend& make_backend, const EpochDone& epoch_done = {});

/// How many epochs it is trained for; 0 for one that is not trained.
std::int64_t epochs_of(const Classifier& classifier, const WdcnnOptions& options);

}  // namespace piae::diagnosis

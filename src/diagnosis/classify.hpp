#pragma once

#include "diagnosis/catalogue.hpp"
#include "diagnosis/wdcnn.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// What a classifier that has the training windows says of the test windows. Of one that is not
/// trained there are the predictions and the scores alone, and `make_backend` is not called. Random
/// numbers come from `stream`, or, of another classifier than the paper's, from its child of that
/// name. Throws as train_and_test() and classify_by_nearest() do.
WdcnnResult classify(const Classifier& classifier, const signal::WindowSet& training,
                     const signal::WindowSet& test, const WdcnnOptions& options,
                     const Stream& stream, const MakeWdcnnBackend& make_backend,
                     const EpochDone& epoch_done = {});

}  // namespace piae::diagnosis

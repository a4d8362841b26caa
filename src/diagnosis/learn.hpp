#pragma once

#include <memory>

#include "diagnosis/catalogue.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/wdcnn_backend.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Has a classifier learn from the training windows. `normal` is B as `split` made it: generated
/// windows beside them in `training` are silent on their place, and then no window of that set says
/// it. `options` and `make_backend` are for WDCNN. Random numbers come from `stream`, or, of
/// another classifier than the paper's, from its child of that name. Throws as train_wdcnn(),
/// Nearest, TrainedRule and train_symptom_net() do.
Learned learn(const Classifier& classifier, const signal::WindowSet& normal,
              const signal::WindowSet& training, const WdcnnOptions& options, const Stream& stream,
              const MakeWdcnnBackend& make_backend, const EpochDone& epoch_done = {});

/// What Trained::write() wrote of a classifier of windows of that data set, `length` samples each.
/// Throws artefact::Refusal for what is not one.
std::unique_ptr<Trained> read_learned(const Classifier& classifier, const artefact::Reader& reader,
                                      const signal::DatasetInfo& info, std::size_t length);

/// How many epochs it is trained for; 0 for one that is not trained.
std::int64_t epochs_of(const Classifier& classifier, const WdcnnOptions& options);

}  // namespace piae::diagnosis

#pragma once

#include <memory>

#include "diagnosis/catalogue.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/learning_settings.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Trains a classifier on the training windows. `normal` is B as `split` made it, because
/// `training` loses the windows' positions once it holds generated windows. Random numbers come
/// from `stream` for the paper's classifier, and from the stream's child of the classifier's name
/// for others. Throws as train_wdcnn(), Nearest, TrainedRule, train_symptom_net() and
/// fit_any_bearing() do, and Error(usage) without a network. A classifier that adapts needs
/// `settings.unlabelled`.
Learned learn(const Classifier& classifier, const signal::WindowSet& normal,
              const signal::WindowSet& training, const LearningSettings& settings,
              const Stream& stream, const EpochDone& epoch_done = {});

/// Reads what Trained::write() wrote for windows of that data set, `length` samples each. Throws
/// artefact::Refusal for other content.
std::unique_ptr<Trained> read_learned(const Classifier& classifier, const artefact::Reader& reader,
                                      const signal::DatasetInfo& info, std::size_t length);

/// Returns the number of training epochs; 0 for classifiers without training.
std::int64_t epochs_of(const Classifier& classifier, const WdcnnOptions& options);

}  // namespace piae::diagnosis

#pragma once

#include <vector>

#include "base/label.hpp"
#include "base/random.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/symptom_network.hpp"

namespace piae::diagnosis {

/// Settings for training a network on symptoms. They matter little, because the network is small
/// and its few inputs share one scale: dropout and noise gain half a point on hit-sm, weight decay
/// nothing.
struct SymptomTraining {
  static constexpr std::int64_t epochs = 60;
  static constexpr std::int64_t batch = 64;
  static constexpr double learning_rate =
      2e-3;            ///< of Adam in epoch 1; falls as half a cosine to 0
  double noise = 0.1;  ///< added to the symptoms, in their standard deviations
};

/// Trains on scaled symptoms. Order, noise and dropout of epoch e, counted from 1, come from
/// stream.child("epoch<e>") and its children "noise" and "dropout".
Training train_on_symptoms(SymptomNetwork& network, const SymptomRows& rows,
                           const std::vector<Label>& labels, const SymptomTraining& settings,
                           const Stream& stream, const EpochDone& epoch_done = {});

}  // namespace piae::diagnosis

#pragma once

#include "base/random.hpp"
#include "diagnosis/wdcnn.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// How symptom-net is trained. It is small, and its inputs are few and of one scale, so that these
/// hardly matter: dropout and noise are worth half a point on hit-sm, weight decay nothing.
struct SymptomTraining {
  static constexpr std::int64_t epochs = 60;
  static constexpr std::int64_t batch = 64;
  static constexpr double learning_rate =
      2e-3;                             ///< of Adam in epoch 1; falls as half a cosine to 0
  static constexpr double noise = 0.1;  ///< added to the symptoms, in their standard deviations
};

/// Trains the network symptom-net (symptom_network.hpp) on the symptoms (symptom_inputs.hpp) of B
/// and of all fault windows in `training`, and tries that of the last epoch on the test windows.
/// Initial values come from stream.child("initial"); order, noise and dropout of epoch e, counted
/// from 1, from stream.child("epoch<e>") and its children "noise" and "dropout". Throws as
/// symptom_inputs() does.
WdcnnResult train_and_test_symptoms(const signal::WindowSet& normal,
                                    const signal::WindowSet& training,
                                    const signal::WindowSet& test, const Stream& stream,
                                    const EpochDone& epoch_done = {});

}  // namespace piae::diagnosis

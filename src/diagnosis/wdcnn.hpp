#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/label.hpp"
#include "base/random.hpp"
#include "diagnosis/standardise.hpp"
#include "diagnosis/wdcnn_backend.hpp"
#include "diagnosis/wdcnn_options.hpp"

namespace piae::diagnosis {

/// What a training gave, and what the trained network says of the n test windows.
struct WdcnnResult {
  std::vector<double> loss;            ///< [epochs] mean cross-entropy over the epoch's windows
  std::vector<double> train_accuracy;  ///< [epochs] in [0, 1]; each window before its own update
  WdcnnOutputs outputs;                ///< of each test window
  std::vector<Label> predictions;      ///< [n] the class with the highest score
  double training_seconds = 0;         ///< time of the epochs, without start-up and test
};

/// Called after every epoch with the number of epochs done and the loss of the last.
using EpochDone = std::function<void(std::int64_t done, double loss)>;

/// Trains WDCNN (paper-notes, "The classifier"; layers in wdcnn_layers.hpp) with Adam on the
/// cross-entropy, and tries the network of the last epoch on the test windows. No epoch is chosen
/// by how well it does on them. Initial values come from stream.child("initial"), and the order of
/// the windows in epoch e, counted from 1, from stream.child("epoch<e>"), so every back end starts
/// from the same network and sees the same batches. Throws Error(bad_input) for fewer than two
/// training windows, no test window, or windows that are too short or of two lengths; Error(failed)
/// when the loss becomes NaN or infinite.
WdcnnResult train_and_test(LabelledWindows train, const LabelledWindows& test,
                           const WdcnnOptions& options, const Stream& stream,
                           const MakeWdcnnBackend& make_backend, const EpochDone& epoch_done = {});

}  // namespace piae::diagnosis

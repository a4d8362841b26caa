#pragma once

#include <cstdint>
#include <memory>

#include "base/random.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/standardise.hpp"
#include "diagnosis/wdcnn_backend.hpp"
#include "diagnosis/wdcnn_options.hpp"

namespace piae::diagnosis {

/// A network, and how it came to be.
struct TrainedWdcnn {
  std::unique_ptr<Wdcnn> network;
  Training training;
};

/// Trains WDCNN (paper-notes, "The classifier"; layers in wdcnn_layers.hpp) with Adam on the
/// cross-entropy. The network is that of the last epoch; none is chosen by how well it does.
/// Initial values come from stream.child("initial"), and the order of the windows in epoch e,
/// counted from 1, from stream.child("epoch<e>"), so every back end starts from the same network
/// and sees the same batches. Throws Error(bad_input) for fewer than two training windows or
/// windows that are too short; Error(failed) when the loss becomes NaN or infinite.
TrainedWdcnn train_wdcnn(LabelledWindows train, const WdcnnOptions& options, const Stream& stream,
                         const MakeWdcnnBackend& make_backend, const EpochDone& epoch_done = {});

/// What a network for windows of `length` samples, or bands of spectra, makes of others. Throws
/// Error(bad_input) for no window, or windows of another length; Error(failed) where a score is not
/// finite, as after a training that has diverged.
Outputs ask_wdcnn(Wdcnn& network, std::size_t length, const LabelledWindows& windows);

}  // namespace piae::diagnosis

#pragma once

#include <cstdint>
#include <memory>

#include "base/random.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/standardise.hpp"
#include "diagnosis/wdcnn_backend.hpp"
#include "diagnosis/wdcnn_options.hpp"

namespace piae::diagnosis {

/// A network and the course of its training.
struct TrainedWdcnn {
  std::unique_ptr<Wdcnn> network;
  Training training;
};

/// Trains WDCNN (paper-notes, "The classifier"; layers in wdcnn_layers.hpp) with Adam on the
/// cross-entropy. Returns the network of the last epoch, not the best one. Initial values come from
/// stream.child("initial"), and the order of the windows in epoch e, counted from 1, from
/// stream.child("epoch<e>"), so every back end starts from the same network and uses the same
/// batches. Throws Error(bad_input) for fewer than two training windows or windows that are too
/// short; Error(failed) if the loss becomes NaN or infinite.
TrainedWdcnn train_wdcnn(LabelledWindows train, const WdcnnOptions& options, const Stream& stream,
                         const MakeWdcnnBackend& make_backend, const EpochDone& epoch_done = {});

/// Returns a network's output; `length` is its input length, samples or bands of spectra. Throws
/// Error(bad_input) without windows or for windows of another length; Error(failed) if a score is
/// not finite, as after a training that has diverged.
Outputs predict_by_wdcnn(Wdcnn& network, std::size_t length, const LabelledWindows& windows);

}  // namespace piae::diagnosis

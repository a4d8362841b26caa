#include "diagnosis/wdcnn.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "diagnosis/batches.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "nets/divergence.hpp"

namespace piae::diagnosis {

namespace {

void require_trainable(const LabelledWindows& train) {
  if (train.size() < 2) {
    throw Error(Exit::bad_input, "WDCNN: " + std::to_string(train.size()) +
                                     " training windows; batch normalisation needs 2 or more");
  }
  if (static_cast<std::int64_t>(train.length) < WdcnnLayers::shortest_window) {
    throw Error(Exit::bad_input, "WDCNN: windows of " + std::to_string(train.length) +
                                     " samples are too short; it needs at least " +
                                     std::to_string(WdcnnLayers::shortest_window));
  }
}

/// Runs one epoch; `epoch` is counted from 1.
void run_epoch(WdcnnBackend& backend, std::size_t windows, std::int64_t epoch,
               const WdcnnOptions& options, const Stream& stream, Training& training) {
  backend.begin_epoch(stream.child("epoch" + std::to_string(epoch)).permutation(windows));
  const std::vector<std::int64_t> bounds =
      batch_bounds(static_cast<std::int64_t>(windows), options.batch);
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) backend.step(bounds[i], bounds[i + 1]);
  const BatchOutcome sums = backend.finish_epoch();
  const auto n = static_cast<double>(windows);
  training.loss.push_back(sums.loss / n);
  training.train_accuracy.push_back(static_cast<double>(sums.correct) / n);
  nets::require_finite(training.loss.back(), "the training of WDCNN",
                       static_cast<std::size_t>(epoch), {.value = options.learning_rate});
}

}  // namespace

TrainedWdcnn train_wdcnn(LabelledWindows train, const WdcnnOptions& options, const Stream& stream,
                         const MakeWdcnnBackend& make_backend, const EpochDone& epoch_done) {
  require_trainable(train);
  const std::size_t windows = train.size();
  std::unique_ptr<WdcnnBackend> backend =
      make_backend(std::move(train), options, stream.child("initial"));
  Training training;
  const auto start = std::chrono::steady_clock::now();
  for (std::int64_t epoch = 1; epoch <= options.epochs; ++epoch) {
    run_epoch(*backend, windows, epoch, options, stream, training);
    if (epoch_done) epoch_done(epoch, training.loss.back());
  }
  training.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {.network = std::move(backend), .training = std::move(training)};
}

Outputs predict_by_wdcnn(Wdcnn& network, std::size_t length, const LabelledWindows& windows) {
  if (windows.size() == 0) {
    throw Error(Exit::bad_input, "WDCNN: test windows are missing; give 1 or more");
  }
  if (windows.length != length) {
    throw Error(Exit::bad_input, "WDCNN: training windows of " + std::to_string(length) +
                                     " samples, test windows of " + std::to_string(windows.length) +
                                     "; both must be the same: give files of one split");
  }
  Outputs outputs = network.outputs(windows);
  if (!std::ranges::all_of(outputs.scores, [](float score) { return std::isfinite(score); })) {
    throw Error(
        Exit::failed,
        "WDCNN: the outputs for a window are not finite, because its training has diverged; "
        "use a smaller --learning-rate");
  }
  return outputs;
}

}  // namespace piae::diagnosis

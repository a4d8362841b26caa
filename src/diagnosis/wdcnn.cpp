#include "diagnosis/wdcnn.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "diagnosis/batches.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "nets/divergence.hpp"

namespace piae::diagnosis {

namespace {

void require_usable(const LabelledWindows& train, const LabelledWindows& test) {
  if (train.size() < 2) {
    throw Error(Exit::bad_input, "WDCNN: " + std::to_string(train.size()) +
                                     " training windows; batch normalisation needs at least 2");
  }
  if (test.size() == 0) throw Error(Exit::bad_input, "WDCNN: no test window; give at least 1");
  if (train.length != test.length || train.classes != test.classes) {
    throw Error(Exit::bad_input, "WDCNN: training windows of " + std::to_string(train.length) +
                                     " samples and " + std::to_string(train.classes) +
                                     " classes, test windows of " + std::to_string(test.length) +
                                     " and " + std::to_string(test.classes) +
                                     "; both must be the same");
  }
  if (static_cast<std::int64_t>(train.length) < WdcnnLayers::shortest_window) {
    throw Error(Exit::bad_input, "WDCNN: windows of " + std::to_string(train.length) +
                                     " samples are too short; it needs at least " +
                                     std::to_string(WdcnnLayers::shortest_window));
  }
}

const std::string training = "the training of WDCNN";  // in errors

/// `epoch` is counted from 1.
void run_epoch(WdcnnBackend& backend, std::size_t windows, std::int64_t epoch,
               const WdcnnOptions& options, const Stream& stream, WdcnnResult& result) {
  backend.begin_epoch(stream.child("epoch" + std::to_string(epoch)).permutation(windows));
  const std::vector<std::int64_t> bounds =
      batch_bounds(static_cast<std::int64_t>(windows), options.batch);
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) backend.step(bounds[i], bounds[i + 1]);
  const BatchOutcome sums = backend.finish_epoch();
  const auto n = static_cast<double>(windows);
  result.loss.push_back(sums.loss / n);
  result.train_accuracy.push_back(static_cast<double>(sums.correct) / n);
  nets::require_finite(result.loss.back(), training, static_cast<std::size_t>(epoch),
                       {.value = options.learning_rate});
}

void train(WdcnnBackend& backend, std::size_t windows, const WdcnnOptions& options,
           const Stream& stream, const EpochDone& epoch_done, WdcnnResult& result) {
  const auto start = std::chrono::steady_clock::now();
  for (std::int64_t epoch = 1; epoch <= options.epochs; ++epoch) {
    run_epoch(backend, windows, epoch, options, stream, result);
    if (epoch_done) epoch_done(epoch, result.loss.back());
  }
  result.training_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void test(WdcnnBackend& backend, const LabelledWindows& set, const WdcnnOptions& options,
          WdcnnResult& result) {
  result.outputs = backend.outputs(set);
  const std::vector<float>& scores = result.outputs.scores;
  if (!std::ranges::all_of(scores, [](float score) { return std::isfinite(score); })) {
    nets::throw_diverged(training, static_cast<std::size_t>(options.epochs),
                         {.value = options.learning_rate});
  }
  const auto classes = static_cast<std::ptrdiff_t>(set.classes);
  for (auto row = scores.begin(); row != scores.end(); row += classes) {
    result.predictions.push_back(static_cast<Label>(std::max_element(row, row + classes) - row));
  }
}

}  // namespace

WdcnnResult train_and_test(LabelledWindows train_set, const LabelledWindows& test_set,
                           const WdcnnOptions& options, const Stream& stream,
                           const MakeWdcnnBackend& make_backend, const EpochDone& epoch_done) {
  require_usable(train_set, test_set);
  const std::size_t windows = train_set.size();
  const std::unique_ptr<WdcnnBackend> backend =
      make_backend(std::move(train_set), options, stream.child("initial"));
  WdcnnResult result;
  train(*backend, windows, options, stream, epoch_done, result);
  test(*backend, test_set, options, result);
  return result;
}

}  // namespace piae::diagnosis

#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "diagnosis/wdcnn_backend.hpp"

namespace piae::diagnosis {

/// A back end that computes one batch after another on the processor. It keeps the windows in the
/// order of the epoch; learn() sees only those of its batch.
class BatchwiseBackend : public WdcnnBackend {
 public:
  explicit BatchwiseBackend(LabelledWindows train) : train_(std::move(train)) {}

  void begin_epoch(std::span<const std::size_t> order) final {
    windows_.clear();
    labels_.clear();
    for (const std::size_t i : order) {
      windows_.push_back(train_.samples.data() + i * train_.length);
      labels_.push_back(train_.labels[i]);
    }
    sums_ = {};
  }

  void step(std::int64_t begin, std::int64_t end) final {
    const auto first = static_cast<std::size_t>(begin);
    const auto count = static_cast<std::size_t>(end - begin);
    const BatchOutcome batch =
        learn(std::span(windows_).subspan(first, count), std::span(labels_).subspan(first, count));
    sums_.loss += batch.loss;
    sums_.correct += batch.correct;
  }

  BatchOutcome finish_epoch() final { return sums_; }

 protected:
  /// Takes one step of Adam on a batch: windows of train().length samples each. Returns the sums
  /// over the batch at the parameters before the step.
  virtual BatchOutcome learn(std::span<const float* const> windows,
                             std::span<const Label> labels) = 0;

  [[nodiscard]] const LabelledWindows& train() const { return train_; }

 private:
  LabelledWindows train_;
  std::vector<const float*> windows_;  ///< in the order of the epoch, pointers into train_
  std::vector<Label> labels_;
  BatchOutcome sums_;
};

}  // namespace piae::diagnosis

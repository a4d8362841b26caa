#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "diagnosis/wdcnn_backend.hpp"

namespace piae::bench {

/// WDCNN on the primitives of a library: only training, in batches of one
/// size. Everything else, such as the order of the windows, is the same as for our own back end.
class EngineBackend : public diagnosis::WdcnnBackend {
 public:
  explicit EngineBackend(diagnosis::LabelledWindows train) : train_(std::move(train)) {}

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
    const diagnosis::BatchOutcome batch =
        learn(std::span(windows_).subspan(first, count), std::span(labels_).subspan(first, count));
    sums_.loss += batch.loss;
    sums_.correct += batch.correct;
  }

  diagnosis::BatchOutcome finish_epoch() final { return sums_; }

  diagnosis::Outputs outputs(const diagnosis::LabelledWindows& /*windows*/) final {
    throw std::logic_error("a back end of the benchmark only trains");
  }
  [[nodiscard]] diagnosis::WdcnnWeights weights() const final {
    throw std::logic_error("a back end of the benchmark only trains");
  }

 protected:
  /// Takes one step of Adam on a batch.
  virtual diagnosis::BatchOutcome learn(std::span<const float* const> windows,
                                        std::span<const Label> labels) = 0;

 private:
  diagnosis::LabelledWindows train_;
  std::vector<const float*> windows_;
  std::vector<Label> labels_;
  diagnosis::BatchOutcome sums_;
};

/// oneDNN's primitives for convolutions, batch normalisation with ReLU, pooling and dense layers,
/// in the layouts that it chooses.
std::unique_ptr<diagnosis::WdcnnBackend> make_onednn_backend(diagnosis::LabelledWindows train,
                                                             const diagnosis::WdcnnOptions& options,
                                                             const Stream& initial);

}  // namespace piae::bench

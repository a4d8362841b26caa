#include "diagnosis/one_core_backend.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/label.hpp"
#include "diagnosis/batches.hpp"
#include "diagnosis/batchwise_backend.hpp"
#include "diagnosis/wdcnn_evaluation.hpp"
#include "diagnosis/wdcnn_network.hpp"
#include "nets/adam.hpp"

namespace piae::diagnosis {

namespace {

using Network = WdcnnNetwork<float>;

std::int64_t largest_batch(std::int64_t n, std::int64_t batch) {
  const std::vector<std::int64_t> bounds = batch_bounds(n, batch);
  std::int64_t largest = 0;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
    largest = std::max(largest, bounds[i + 1] - bounds[i]);
  }
  return largest;
}

class OneCoreBackend final : public BatchwiseBackend {
 public:
  /// `adversity` is null for a network that does not adapt.
  OneCoreBackend(LabelledWindows windows, const WdcnnOptions& options, const Stream& initial,
                 const Adversity* adversity)
      : BatchwiseBackend(std::move(windows)),
        learning_rate_(options.learning_rate),
        most_windows_(largest_batch(static_cast<std::int64_t>(train().size()), options.batch)),
        network_(static_cast<std::int64_t>(train().length),
                 static_cast<std::int64_t>(train().classes),
                 most_windows_ * (adversity == nullptr ? 1 : 2), initial),
        adam_(network_.values().size()) {
    if (adversity == nullptr) return;
    const auto count = static_cast<std::int64_t>(train().size());
    const std::int64_t steps = std::ssize(batch_bounds(count, options.batch)) - 1;
    adversary_.emplace(*adversity, train().length, static_cast<std::int64_t>(train().classes),
                       most_windows_, options.epochs * steps, options.learning_rate, initial);
  }

  Outputs outputs(const LabelledWindows& windows) override {
    return outputs_of(network_, most_windows_, windows);
  }

  [[nodiscard]] WdcnnWeights weights() const override { return network_.weights(); }

 private:
  BatchOutcome learn(std::span<const float* const> windows,
                     std::span<const Label> labels) override {
    network_.forward(adversary_ ? adversary_->joined(windows) : windows, Network::Mode::training);
    const BatchOutcome batch = network_.backward(
        labels, adversary_ ? adversary_->gradient(network_) : std::span<const float>{});
    adam_.step(network_.values().data(), network_.gradients().data(), learning_rate_);
    return batch;
  }

  double learning_rate_;
  std::int64_t most_windows_;  ///< in a batch
  Network network_;
  nets::Adam<float> adam_;
  std::optional<Adversary> adversary_;
};

}  // namespace

std::unique_ptr<WdcnnBackend> make_one_core_backend(LabelledWindows train,
                                                    const WdcnnOptions& options,
                                                    const Stream& initial) {
  return std::make_unique<OneCoreBackend>(std::move(train), options, initial, nullptr);
}

MakeWdcnnBackend adapting_backend(Adversity settings) {
  return [settings = std::move(settings)](LabelledWindows train, const WdcnnOptions& options,
                                          const Stream& initial) {
    return std::make_unique<OneCoreBackend>(std::move(train), options, initial, &settings);
  };
}

}  // namespace piae::diagnosis

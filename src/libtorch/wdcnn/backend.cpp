#include "libtorch/wdcnn/backend.hpp"

#include "diagnosis/wdcnn_weights.hpp"
#include "libtorch/nets/adam.hpp"
#include "libtorch/nets/device.hpp"
#include "libtorch/nets/torch.hpp"
#include "libtorch/wdcnn/network.hpp"

namespace piae::libtorch {

namespace {

using Mode = WdcnnNetwork::Mode;

/// Number of windows that are tested at a time: large enough to spread the overhead, and small
/// enough for the caches.
constexpr std::int64_t test_batch = 100;

torch::Tensor to_tensor(const diagnosis::LabelledWindows& set, torch::Device device) {
  const torch::Tensor windows =
      torch::empty({static_cast<std::int64_t>(set.size()), static_cast<std::int64_t>(set.length)},
                   torch::kFloat32);
  copy_into(windows.view(-1), set.samples);
  return windows.to(device);
}

class WdcnnOnTorch final : public diagnosis::WdcnnBackend {
 public:
  WdcnnOnTorch(const diagnosis::LabelledWindows& train, const diagnosis::WdcnnOptions& options,
               const Stream& initial, torch::Device device)
      : device_(device),
        learning_rate_(options.learning_rate),
        network_(static_cast<std::int64_t>(train.length), static_cast<std::int64_t>(train.classes),
                 initial, torch::kFloat32, device),
        adam_(network_.parameters().values(), network_.parameters().gradients()),
        windows_(to_tensor(train, device)),
        labels_(torch::tensor(train.labels, torch::kInt64).to(device)),
        shuffled_windows_(torch::empty_like(windows_)),
        shuffled_labels_(torch::empty_like(labels_)) {}

  /// Copies all windows into the order of this epoch, so that batches are views.
  void begin_epoch(std::span<const std::size_t> order) override {
    const torch::Tensor index =
        torch::tensor(std::vector<std::int64_t>(order.begin(), order.end()), torch::kInt64)
            .to(device_);
    torch::index_select_out(shuffled_windows_, windows_, 0, index);
    torch::index_select_out(shuffled_labels_, labels_, 0, index);
    loss_sum_ = torch::zeros({}, windows_.options().dtype(torch::kFloat64));
    correct_ = torch::zeros({}, labels_.options());
  }

  void step(std::int64_t begin, std::int64_t end) override {
    const torch::Tensor labels = shuffled_labels_.slice(0, begin, end);
    network_.parameters().zero_gradients();
    const torch::Tensor logits =
        network_.forward(shuffled_windows_.slice(0, begin, end), Mode::training);
    const torch::Tensor loss = torch::cross_entropy_loss(logits, labels);
    loss.backward();
    adam_.step(learning_rate_);
    // Keep these sums on the device, so that no step has to wait for a GPU.
    loss_sum_ += loss.detach().to(torch::kFloat64) * (end - begin);
    correct_ += logits.detach().argmax(1).eq(labels).sum();
  }

  diagnosis::BatchOutcome finish_epoch() override {
    return {.loss = loss_sum_.item<double>(), .correct = correct_.item<std::int64_t>()};
  }

  diagnosis::Outputs outputs(const diagnosis::LabelledWindows& windows) override {
    const torch::NoGradGuard no_grad;
    std::vector<torch::Tensor> hidden;
    std::vector<torch::Tensor> logits;
    std::vector<torch::Tensor> scores;
    for (const torch::Tensor& batch : to_tensor(windows, device_).split(test_batch)) {
      hidden.push_back(network_.hidden(batch, Mode::evaluation));
      logits.push_back(network_.classify(hidden.back()));
      scores.push_back(logits.back().softmax(1));
    }
    return {.hidden = to_vector(torch::cat(hidden)),
            .logits = to_vector(torch::cat(logits)),
            .scores = to_vector(torch::cat(scores))};
  }

  [[nodiscard]] diagnosis::WdcnnWeights weights() const override {
    const torch::NoGradGuard no_grad;
    diagnosis::WdcnnWeights weights{.length = windows_.size(1),
                                    .classes = network_.classes(),
                                    .parameters = to_vector(network_.parameters().values()),
                                    .running_means = {},
                                    .running_variances = {}};
    for (std::size_t i = 0; i < diagnosis::layers_with_normalisation; ++i) {
      weights.running_means.push_back(to_vector(network_.running(i).mean));
      weights.running_variances.push_back(to_vector(network_.running(i).variance));
    }
    return weights;
  }

 private:
  torch::Device device_;
  double learning_rate_;
  WdcnnNetwork network_;
  Adam adam_;
  torch::Tensor windows_;  ///< float32 [n, length]
  torch::Tensor labels_;   ///< int64 [n]
  torch::Tensor shuffled_windows_;
  torch::Tensor shuffled_labels_;
  torch::Tensor loss_sum_;
  torch::Tensor correct_;
};

}  // namespace

diagnosis::MakeWdcnnBackend wdcnn_on(Device device) {
  return [device = prepare_device(device)](const diagnosis::LabelledWindows& train,
                                           const diagnosis::WdcnnOptions& options,
                                           const Stream& initial) {
    return std::make_unique<WdcnnOnTorch>(train, options, initial, device);
  };
}

}  // namespace piae::libtorch

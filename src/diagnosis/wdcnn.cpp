#include "diagnosis/wdcnn.hpp"

#include <spdlog/fmt/fmt.h>
#include <torch/torch.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/error.hpp"
#include "diagnosis/batches.hpp"
#include "diagnosis/wdcnn_network.hpp"
#include "nets/adam.hpp"
#include "nets/device.hpp"

namespace piae::diagnosis {

namespace {

using Mode = WdcnnNetwork::Mode;

/// Windows tried at a time: large enough to spread the overhead, small enough for the caches.
constexpr std::int64_t test_batch = 100;

struct Tensors {
  torch::Tensor windows;  ///< float32 [n, length]
  torch::Tensor labels;   ///< int64 [n]
};

Tensors to_tensors(const LabelledWindows& set, torch::Device device) {
  const auto n = static_cast<std::int64_t>(set.size());
  const auto length = static_cast<std::int64_t>(set.length);
  Tensors tensors{torch::empty({n, length}, torch::kFloat32),
                  torch::tensor(set.labels, torch::kInt64).to(device)};
  nets::copy_into(tensors.windows.view(-1), set.samples);
  tensors.windows = tensors.windows.to(device);
  return tensors;
}

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

[[noreturn]] void report_divergence(const std::string& what, const WdcnnOptions& options) {
  throw Error(Exit::failed, "WDCNN: " + what + " became NaN or infinite with --learning-rate " +
                                fmt::format("{:g}", options.learning_rate) +
                                "; a smaller one would work, such as 0.001");
}

/// Trains the network, one epoch at a time.
class Training {
 public:
  Training(WdcnnNetwork& network, const Tensors& set, const WdcnnOptions& options,
           const Stream& stream)
      : network_(network),
        set_(set),
        options_(options),
        stream_(stream),
        adam_(network.parameters().values(), network.parameters().gradients()),
        bounds_(batch_bounds(set.labels.size(0), options.batch)),
        shuffled_{torch::empty_like(set.windows), torch::empty_like(set.labels)} {}

  /// `epoch` is counted from 1.
  void run_epoch(std::int64_t epoch, WdcnnResult& result) {
    shuffle(epoch);
    loss_sum_ = torch::zeros({}, set_.windows.options().dtype(torch::kFloat64));
    correct_ = torch::zeros({}, set_.labels.options());
    for (std::size_t i = 0; i + 1 < bounds_.size(); ++i) step(bounds_[i], bounds_[i + 1]);
    const auto n = static_cast<double>(set_.labels.size(0));
    result.loss.push_back(loss_sum_.item<double>() / n);
    result.train_accuracy.push_back(correct_.item<double>() / n);
    if (!std::isfinite(result.loss.back())) {
      report_divergence("the loss in epoch " + std::to_string(epoch), options_);
    }
  }

 private:
  /// All windows at once into the order of this epoch, so that batches are views.
  void shuffle(std::int64_t epoch) {
    const std::vector<std::size_t> order =
        stream_.child("epoch" + std::to_string(epoch))
            .permutation(static_cast<std::size_t>(set_.labels.size(0)));
    const torch::Tensor index =
        torch::tensor(std::vector<std::int64_t>(order.begin(), order.end()), torch::kInt64)
            .to(set_.labels.device());
    torch::index_select_out(shuffled_.windows, set_.windows, 0, index);
    torch::index_select_out(shuffled_.labels, set_.labels, 0, index);
  }

  void step(std::int64_t begin, std::int64_t end) {
    const torch::Tensor labels = shuffled_.labels.slice(0, begin, end);
    network_.parameters().zero_gradients();
    const torch::Tensor logits =
        network_.forward(shuffled_.windows.slice(0, begin, end), Mode::training);
    const torch::Tensor loss = torch::nn::functional::cross_entropy(logits, labels);
    loss.backward();
    adam_.step(options_.learning_rate);
    // Summed where the network is, so that a GPU is not waited for at every step.
    loss_sum_ += loss.detach().to(torch::kFloat64) * (end - begin);
    correct_ += logits.detach().argmax(1).eq(labels).sum();
  }

  WdcnnNetwork& network_;
  const Tensors& set_;
  const WdcnnOptions& options_;
  const Stream& stream_;
  nets::Adam adam_;
  std::vector<std::int64_t> bounds_;
  Tensors shuffled_;
  torch::Tensor loss_sum_;
  torch::Tensor correct_;
};

void train(WdcnnNetwork& network, const Tensors& set, const WdcnnOptions& options,
           const Stream& stream, const EpochDone& epoch_done, WdcnnResult& result) {
  Training training(network, set, options, stream);
  const auto start = std::chrono::steady_clock::now();
  for (std::int64_t epoch = 1; epoch <= options.epochs; ++epoch) {
    training.run_epoch(epoch, result);
    if (epoch_done) epoch_done(epoch, result.loss.back());
  }
  result.training_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void test(WdcnnNetwork& network, const Tensors& set, const WdcnnOptions& options,
          WdcnnResult& result) {
  const torch::NoGradGuard no_grad;
  std::vector<torch::Tensor> scores;
  for (const torch::Tensor& windows : set.windows.split(test_batch)) {
    scores.push_back(network.forward(windows, Mode::evaluation).softmax(1));
  }
  const torch::Tensor all = torch::cat(scores).cpu();
  if (!all.isfinite().all().item<bool>()) report_divergence("the scores of the test", options);
  result.scores = nets::to_vector(all);
  const torch::Tensor predictions = all.argmax(1);
  const auto* data = predictions.data_ptr<std::int64_t>();
  result.predictions.assign(data, data + predictions.numel());
}

}  // namespace

WdcnnResult train_and_test(const LabelledWindows& train_set, const LabelledWindows& test_set,
                           const WdcnnOptions& options, const Stream& stream,
                           const std::string& device_name, const EpochDone& epoch_done) {
  require_usable(train_set, test_set);
  const torch::Device device = nets::prepare_device(device_name);
  WdcnnNetwork network(static_cast<std::int64_t>(train_set.length),
                       static_cast<std::int64_t>(train_set.classes), stream.child("initial"),
                       torch::kFloat32, device);
  WdcnnResult result;
  train(network, to_tensors(train_set, device), options, stream, epoch_done, result);
  test(network, to_tensors(test_set, device), options, result);
  return result;
}

}  // namespace piae::diagnosis

// Compares our network for one core with LibTorch's in single and double precision.

#include <gtest/gtest.h>
#include <torch/optim/adam.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "diagnosis/domain_classifier.hpp"
#include "diagnosis/random_batch.hpp"
#include "diagnosis/wdcnn_network.hpp"
#include "libtorch/nets/torch.hpp"
#include "libtorch/wdcnn/network.hpp"
#include "nets/adam.hpp"

namespace piae::diagnosis {
namespace {

constexpr std::int64_t classes = 10;
constexpr double learning_rate = 1e-3;

template <class T>
constexpr torch::Dtype dtype = std::is_same_v<T, float> ? torch::kFloat32 : torch::kFloat64;

/// Tolerance relative to the largest compared number.
template <class T>
constexpr double tolerance = std::is_same_v<T, float> ? 1e-5 : 1e-12;

RandomBatch batch_of(std::int64_t n, std::int64_t length = 1024,
                     const std::string& name = "windows") {
  return random_batch(n, length, classes, name);
}

template <class T>
std::vector<double> numbers(const torch::Tensor& tensor) {
  const torch::Tensor flat = tensor.detach().to(torch::kFloat64).contiguous();
  return {flat.data_ptr<double>(), flat.data_ptr<double>() + flat.numel()};
}

/// Both networks with the same parameters, and both optimisers. Scales and shifts of batch
/// normalisation differ from 1 and 0; some scales are negative.
template <class T>
struct Pair {
  explicit Pair(std::int64_t length, std::int64_t most_windows = 40)
      : mine(length, classes, most_windows, Stream("network")),
        theirs(length, classes, Stream("network"), dtype<T>),
        own_adam(mine.values().size()),
        libtorch_adam(libtorch_parameters(), torch::optim::AdamOptions(learning_rate)) {
    const torch::NoGradGuard no_grad;
    for (const WdcnnParameter& parameter : mine.layout()) {
      if (parameter.spec.shape.size() != 1) continue;
      torch::Tensor tensor = theirs.parameters()[parameter.spec.name];
      tensor.add_(1.2 * torch::cos(torch::arange(tensor.numel(), dtype<T>)));
      parameter.for_each([&](std::int64_t i, std::int64_t j) {
        mine.values()[static_cast<std::size_t>(j)] = tensor.template data_ptr<T>()[i];
      });
    }
  }

  std::vector<torch::Tensor> libtorch_parameters() {
    std::vector<torch::Tensor> parameters;
    for (const WdcnnParameter& parameter : mine.layout()) {
      parameters.push_back(theirs.parameters()[parameter.spec.name]);
    }
    return parameters;
  }

  void step() {
    own_adam.step(mine.values().data(), mine.gradients().data(), learning_rate);
    libtorch_adam.step();
  }

  torch::Tensor tensor_of(const RandomBatch& batch) const {
    return torch::tensor(batch.samples)
        .to(dtype<T>)
        .view({static_cast<std::int64_t>(batch.windows.size()), batch.length});
  }

  std::vector<double> own_logits(const RandomBatch& batch, bool training) {
    using Mode = typename WdcnnNetwork<T>::Mode;
    const T* row = mine.forward(batch.windows, training ? Mode::training : Mode::evaluation);
    std::vector<double> logits;
    for (std::size_t i = 0; i < batch.windows.size(); ++i, row += mine.logits_row()) {
      logits.insert(logits.end(), row, row + classes);
    }
    return logits;
  }

  std::vector<double> libtorch_logits(const RandomBatch& batch, bool training) {
    using Mode = libtorch::WdcnnNetwork::Mode;
    return numbers<T>(
        theirs.forward(tensor_of(batch), training ? Mode::training : Mode::evaluation));
  }

  /// Computes gradients of the mean cross-entropy in both; returns LibTorch's sum over the batch.
  double propagate(const RandomBatch& batch, BatchOutcome& outcome) {
    own_logits(batch, true);
    outcome = mine.backward(batch.labels);
    theirs.parameters().zero_gradients();
    const torch::Tensor logits =
        theirs.forward(tensor_of(batch), libtorch::WdcnnNetwork::Mode::training);
    const torch::Tensor loss =
        torch::cross_entropy_loss(logits, torch::tensor(batch.labels, torch::kInt64));
    loss.backward();
    return loss.template item<double>() * static_cast<double>(batch.labels.size());
  }

  void expect_equal_gradients() {
    for (const WdcnnParameter& parameter : mine.layout()) {
      expect_near(unfolded(parameter, mine.gradients()),
                  numbers<T>(theirs.parameters()[parameter.spec.name].grad()), tolerance<T>,
                  "gradient of " + parameter.spec.name);
    }
  }

  void expect_equal_values(double relative) {
    for (const WdcnnParameter& parameter : mine.layout()) {
      expect_near(unfolded<T>(parameter, mine.values()),
                  numbers<T>(theirs.parameters()[parameter.spec.name]), relative,
                  parameter.spec.name);
    }
  }

  WdcnnNetwork<T> mine;
  libtorch::WdcnnNetwork theirs;
  nets::Adam<T> own_adam;
  torch::optim::Adam libtorch_adam;
};

template <class T>
class OneCoreNetworkOf : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(OneCoreNetworkOf, Precisions, );

TYPED_TEST(OneCoreNetworkOf, StartsFromTheSameParameters) {
  WdcnnNetwork<TypeParam> mine(2048, classes, 2, Stream("network"));
  libtorch::WdcnnNetwork theirs(2048, classes, Stream("network"), dtype<TypeParam>);
  for (const WdcnnParameter& parameter : mine.layout()) {
    EXPECT_EQ(unfolded<TypeParam>(parameter, mine.values()),
              numbers<TypeParam>(theirs.parameters()[parameter.spec.name]));
  }
}

TYPED_TEST(OneCoreNetworkOf, ForwardPassEqualsLibtorchs) {
  for (const std::int64_t length : {1024, 1040, 2048}) {  // 1040: one value is left over in pooling
    Pair<TypeParam> pair(length);
    for (const std::int64_t windows : {7, 40, 2}) {
      const RandomBatch batch = batch_of(windows, length);
      expect_near(pair.own_logits(batch, true), pair.libtorch_logits(batch, true),
                  tolerance<TypeParam>, "training");
      expect_near(pair.own_logits(batch, false), pair.libtorch_logits(batch, false),
                  tolerance<TypeParam>, "evaluation");
    }
  }
}

TYPED_TEST(OneCoreNetworkOf, RunningStatisticsEqualLibtorchs) {
  Pair<TypeParam> pair(1024);
  for (const char* name : {"first", "second", "third"}) {
    const RandomBatch batch = batch_of(9, 1024, name);
    pair.own_logits(batch, true);
    pair.libtorch_logits(batch, true);
  }
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& theirs = pair.theirs.running(i);
    const auto channels = static_cast<std::size_t>(theirs.mean.numel());
    const auto expect = [&](std::span<const TypeParam> ours, const torch::Tensor& tensor) {
      expect_near({ours.begin(), ours.begin() + static_cast<std::ptrdiff_t>(channels)},
                  numbers<TypeParam>(tensor), tolerance<TypeParam>, "layer " + std::to_string(i));
    };
    expect(pair.mine.running_mean(i), theirs.mean);
    expect(pair.mine.running_variance(i), theirs.variance);
  }
}

TYPED_TEST(OneCoreNetworkOf, GradientsEqualLibtorchs) {
  for (const std::int64_t length : {1024, 1040, 2048}) {
    Pair<TypeParam> pair(length);
    for (const std::int64_t windows : {32, 5}) {
      const RandomBatch batch = batch_of(windows, length);
      BatchOutcome outcome;
      const double loss = pair.propagate(batch, outcome);
      EXPECT_NEAR(outcome.loss, loss, tolerance<TypeParam> * loss);
      pair.expect_equal_gradients();
    }
  }
}

TYPED_TEST(OneCoreNetworkOf, OneUpdateEqualsLibtorchs) {
  Pair<TypeParam> pair(1024);
  const RandomBatch batch = batch_of(32);
  BatchOutcome outcome;
  pair.propagate(batch, outcome);
  pair.step();
  // Adam's first step is the gradient's sign. For gradients of 0, rounding decides the sign, so up
  // to one in 1000 of those may differ.
  for (const WdcnnParameter& parameter : pair.mine.layout()) {
    const auto ours = unfolded<TypeParam>(parameter, pair.mine.values());
    const auto gradient = numbers<TypeParam>(pair.theirs.parameters()[parameter.spec.name].grad());
    const auto theirs = numbers<TypeParam>(pair.theirs.parameters()[parameter.spec.name]);
    double greatest = 0;
    for (const double g : gradient) greatest = std::max(greatest, std::abs(g));
    std::size_t compared = 0;
    std::size_t other = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const double bound = tolerance<TypeParam> * std::abs(theirs[i]) + 1e-8;
      if (gradient[i] != 0 && std::abs(gradient[i]) < 1e-4 * greatest) {
        if (std::abs(ours[i] - theirs[i]) > bound) ++other;
        continue;
      }
      ++compared;
      EXPECT_NEAR(ours[i], theirs[i], bound) << parameter.spec.name << " " << i;
    }
    EXPECT_LE(other, 1 + ours.size() / 1000) << parameter.spec.name;
    EXPECT_GE(compared, ours.size() * 9 / 10) << parameter.spec.name;
  }
}

TEST(OneCoreNetwork, MatchesLibtorchAfterTenUpdates) {
  Pair<double> pair(1024);
  for (int i = 0; i < 10; ++i) {
    BatchOutcome outcome;
    pair.propagate(batch_of(8, 1024, std::to_string(i)), outcome);
    pair.step();
  }
  pair.expect_equal_values(1e-8);
}

/// The domain classifier by LibTorch's operations; returns the mean binary cross-entropy.
torch::Tensor domain_loss(const libtorch::ParameterSet& domains, const torch::Tensor& hidden,
                          const torch::Tensor& logits, Adaptation adaptation) {
  torch::Tensor input = hidden;
  if (adaptation == Adaptation::conditional) {
    const torch::Tensor weights = torch::softmax(logits, 1).detach();
    input = torch::bmm(weights.unsqueeze(2), hidden.unsqueeze(1)).flatten(1);
  }
  const auto layer = [&](const torch::Tensor& x, const std::string& name) {
    return torch::addmm(domains[name + "/bias"], x, domains[name + "/weight"].t());
  };
  const torch::Tensor z = layer(torch::relu(layer(input, "domain/0")), "domain/1").squeeze(1);
  const torch::Tensor is_labelled = torch::zeros_like(z);
  is_labelled.slice(0, 0, z.size(0) / 2).fill_(1);
  return torch::binary_cross_entropy_with_logits(z, is_labelled);
}

TEST(OneCoreNetwork, AdaptsByTheGradientsOfLibtorch) {
  using Domains = DomainClassifier<double>;
  constexpr double reversal = 0.7;
  for (const Adaptation adaptation : {Adaptation::marginal, Adaptation::conditional}) {
    Pair<double> pair(1024);
    const RandomBatch batch = batch_of(12);
    const auto labels = std::span(batch.labels).first(6);
    pair.own_logits(batch, true);
    Domains mine(adaptation, classes, 12, Stream("domains"));
    std::vector<double> by_hidden(static_cast<std::size_t>(12 * pair.mine.hidden_row()));
    const double loss =
        mine.step({.hidden = {pair.mine.hidden(), pair.mine.hidden_row()},
                   .logits = {pair.mine.logits(), pair.mine.logits_row()},
                   .windows = 12,
                   .labelled = 6},
                  learning_rate, reversal, {by_hidden.data(), pair.mine.hidden_row()});
    pair.mine.backward(labels, by_hidden);

    std::vector<nets::ParameterSpec> specs;
    for (const auto& parameter : mine.parameters().parameters()) specs.push_back(parameter.spec);
    const libtorch::ParameterSet theirs(specs, Stream("domains"), torch::kFloat64);
    pair.theirs.parameters().zero_gradients();
    const torch::Tensor hidden =
        pair.theirs.hidden(pair.tensor_of(batch), libtorch::WdcnnNetwork::Mode::training);
    const torch::Tensor logits = pair.theirs.classify(hidden);
    const torch::Tensor of_domains = domain_loss(theirs, hidden, logits, adaptation);
    const torch::Tensor of_classes = torch::cross_entropy_loss(
        logits.slice(0, 0, 6),
        torch::tensor(std::vector(labels.begin(), labels.end()), torch::kInt64));
    (of_classes - reversal * of_domains).backward();
    EXPECT_NEAR(loss, of_domains.item<double>(), 1e-12);
    pair.expect_equal_gradients();
    // After its first step, Adam's first moment is a tenth of the gradient.
    for (const auto& parameter : mine.parameters().parameters()) {
      const double* moment =
          mine.parameters().data(nets::Parameters<double>::Kept::first_moment) + parameter.begin;
      std::vector<double> gradient;
      for (std::int64_t row = 0; row < parameter.rows; ++row, moment += parameter.held_columns) {
        for (std::int64_t i = 0; i < parameter.columns; ++i) {
          gradient.push_back(-reversal * moment[i] / 0.1);
        }
      }
      expect_near(gradient, numbers<double>(theirs[parameter.spec.name].grad()), 1e-9,
                  parameter.spec.name);
    }
  }
}

}  // namespace
}  // namespace piae::diagnosis

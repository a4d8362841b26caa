#include "diagnosis/wdcnn_network.hpp"

#include <gtest/gtest.h>
#include <torch/optim/adam.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "libtorch/wdcnn/network.hpp"
#include "nets/adam.hpp"
#include "libtorch/nets/torch.hpp"

// The native network against LibTorch's, in single and in double precision, and against finite
// differences.

namespace piae::diagnosis {
namespace {

constexpr std::int64_t classes = 10;
constexpr double learning_rate = 1e-3;

template <class T>
constexpr torch::Dtype dtype = std::is_same_v<T, float> ? torch::kFloat32 : torch::kFloat64;

/// Relative to the greatest number of what is compared.
template <class T>
constexpr double tolerance = std::is_same_v<T, float> ? 1e-5 : 1e-12;

struct Batch {
  std::int64_t length;
  std::vector<float> samples;
  std::vector<const float*> windows;
  std::vector<std::int32_t> labels;
};

Batch random_batch(std::int64_t n, std::int64_t length, const std::string& name) {
  Stream stream(name);
  Batch batch{length, std::vector<float>(static_cast<std::size_t>(n * length)), {}, {}};
  for (float& x : batch.samples) x = static_cast<float>(stream.normal(0, 1));
  for (std::int64_t i = 0; i < n; ++i) {
    batch.windows.push_back(batch.samples.data() + i * length);
    batch.labels.push_back(static_cast<std::int32_t>(stream.below(classes)));
  }
  return batch;
}

template <class T>
std::vector<double> numbers(const torch::Tensor& tensor) {
  const torch::Tensor flat = tensor.detach().to(torch::kFloat64).contiguous();
  return {flat.data_ptr<double>(), flat.data_ptr<double>() + flat.numel()};
}

/// A parameter's numbers, or its gradient's, in the order of its shape, out of the flat vector.
template <class T>
std::vector<double> unfolded(const WdcnnParameter& parameter, std::span<const T> flat) {
  std::vector<double> result(static_cast<std::size_t>(parameter.spec.size()));
  parameter.for_each([&](std::int64_t i, std::int64_t j) {
    result[static_cast<std::size_t>(i)] = flat[static_cast<std::size_t>(j)];
  });
  return result;
}

void expect_near(const std::vector<double>& ours, const std::vector<double>& theirs,
                 double relative, const std::string& what) {
  ASSERT_EQ(ours.size(), theirs.size()) << what;
  double greatest = 0;
  for (const double x : theirs) greatest = std::max(greatest, std::abs(x));
  for (std::size_t i = 0; i < ours.size(); ++i) {
    ASSERT_NEAR(ours[i], theirs[i], relative * greatest) << what << " " << i;
  }
}

/// Both networks with the same parameters, scales and shifts of batch normalisation other than 1
/// and 0 (some scales negative), and both optimisers.
template <class T>
struct Pair {
  explicit Pair(std::int64_t length, std::int64_t most_windows = 40)
      : native(length, classes, most_windows, Stream("network")),
        libtorch(length, classes, Stream("network"), dtype<T>),
        native_adam(native.values().size()),
        libtorch_adam(libtorch_parameters(), torch::optim::AdamOptions(learning_rate)) {
    const torch::NoGradGuard no_grad;
    for (const WdcnnParameter& parameter : native.layout()) {
      if (parameter.spec.shape.size() != 1) continue;
      torch::Tensor theirs = libtorch.parameters()[parameter.spec.name];
      theirs.add_(1.2 * torch::cos(torch::arange(theirs.numel(), dtype<T>)));
      parameter.for_each([&](std::int64_t i, std::int64_t j) {
        native.values()[static_cast<std::size_t>(j)] = theirs.template data_ptr<T>()[i];
      });
    }
  }

  std::vector<torch::Tensor> libtorch_parameters() {
    std::vector<torch::Tensor> parameters;
    for (const WdcnnParameter& parameter : native.layout()) {
      parameters.push_back(libtorch.parameters()[parameter.spec.name]);
    }
    return parameters;
  }

  void step() {
    native_adam.step(native.values().data(), native.gradients().data(), learning_rate);
    libtorch_adam.step();
  }

  torch::Tensor tensor_of(const Batch& batch) const {
    return torch::tensor(batch.samples)
        .to(dtype<T>)
        .view({static_cast<std::int64_t>(batch.windows.size()), batch.length});
  }

  std::vector<double> native_logits(const Batch& batch, bool training) {
    using Mode = typename WdcnnNetwork<T>::Mode;
    const T* row = native.forward(batch.windows, training ? Mode::training : Mode::evaluation);
    std::vector<double> logits;
    for (std::size_t i = 0; i < batch.windows.size(); ++i, row += native.logits_row()) {
      logits.insert(logits.end(), row, row + classes);
    }
    return logits;
  }

  std::vector<double> libtorch_logits(const Batch& batch, bool training) {
    using Mode = WdcnnNetwork::Mode;
    return numbers<T>(
        libtorch.forward(tensor_of(batch), training ? Mode::training : Mode::evaluation));
  }

  /// Gradients of the mean cross-entropy in both; returns LibTorch's sum over the batch.
  double propagate(const Batch& batch, BatchOutcome& outcome) {
    native_logits(batch, true);
    outcome = native.backward(batch.labels);
    libtorch.parameters().zero_gradients();
    const torch::Tensor logits = libtorch.forward(tensor_of(batch), WdcnnNetwork::Mode::training);
    const torch::Tensor loss =
        torch::cross_entropy_loss(logits, torch::tensor(batch.labels, torch::kInt64));
    loss.backward();
    return loss.template item<double>() * static_cast<double>(batch.labels.size());
  }

  void expect_equal_gradients() {
    for (const WdcnnParameter& parameter : native.layout()) {
      expect_near(unfolded(parameter, native.gradients()),
                  numbers<T>(libtorch.parameters()[parameter.spec.name].grad()), tolerance<T>,
                  "gradient of " + parameter.spec.name);
    }
  }

  void expect_equal_values(double relative) {
    for (const WdcnnParameter& parameter : native.layout()) {
      expect_near(unfolded<T>(parameter, native.values()),
                  numbers<T>(libtorch.parameters()[parameter.spec.name]), relative,
                  parameter.spec.name);
    }
  }

  WdcnnNetwork<T> native;
  WdcnnNetwork libtorch;
  nets::Adam<T> native_adam;
  torch::optim::Adam libtorch_adam;
};

template <class T>
class NativeNetworkOf : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(NativeNetworkOf, Precisions, );

TYPED_TEST(NativeNetworkOf, StartsFromTheSameParameters) {
  WdcnnNetwork<TypeParam> native(2048, classes, 2, Stream("network"));
  WdcnnNetwork libtorch(2048, classes, Stream("network"), dtype<TypeParam>);
  for (const WdcnnParameter& parameter : native.layout()) {
    EXPECT_EQ(unfolded<TypeParam>(parameter, native.values()),
              numbers<TypeParam>(libtorch.parameters()[parameter.spec.name]));
  }
}

TYPED_TEST(NativeNetworkOf, ForwardPassEqualsLibtorchs) {
  for (const std::int64_t length : {1024, 1040, 2048}) {  // 1040: a time is left over in pooling
    Pair<TypeParam> pair(length);
    for (const std::int64_t windows : {7, 40, 2}) {
      const Batch batch = random_batch(windows, length, "windows");
      expect_near(pair.native_logits(batch, true), pair.libtorch_logits(batch, true),
                  tolerance<TypeParam>, "training");
      expect_near(pair.native_logits(batch, false), pair.libtorch_logits(batch, false),
                  tolerance<TypeParam>, "evaluation");
    }
  }
}

TYPED_TEST(NativeNetworkOf, RunningStatisticsEqualLibtorchs) {
  Pair<TypeParam> pair(1024);
  for (const char* name : {"first", "second", "third"}) {
    const Batch batch = random_batch(9, 1024, name);
    pair.native_logits(batch, true);
    pair.libtorch_logits(batch, true);
  }
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& theirs = pair.libtorch.running(i);
    const auto channels = static_cast<std::size_t>(theirs.mean.numel());
    const auto expect = [&](std::span<const TypeParam> ours, const torch::Tensor& tensor) {
      expect_near({ours.begin(), ours.begin() + static_cast<std::ptrdiff_t>(channels)},
                  numbers<TypeParam>(tensor), tolerance<TypeParam>, "layer " + std::to_string(i));
    };
    expect(pair.native.running_mean(i), theirs.mean);
    expect(pair.native.running_variance(i), theirs.variance);
  }
}

TYPED_TEST(NativeNetworkOf, GradientsEqualLibtorchs) {
  for (const std::int64_t length : {1024, 1040, 2048}) {
    Pair<TypeParam> pair(length);
    for (const std::int64_t windows : {32, 5}) {
      const Batch batch = random_batch(windows, length, "windows");
      BatchOutcome outcome;
      const double loss = pair.propagate(batch, outcome);
      EXPECT_NEAR(outcome.loss, loss, tolerance<TypeParam> * loss);
      pair.expect_equal_gradients();
    }
  }
}

TYPED_TEST(NativeNetworkOf, OneUpdateEqualsLibtorchs) {
  Pair<TypeParam> pair(1024);
  const Batch batch = random_batch(32, 1024, "windows");
  BatchOutcome outcome;
  pair.propagate(batch, outcome);
  pair.step();
  // Adam's first step is the gradient's sign, which rounding decides where the gradient is nothing:
  // of those, one in 1000 may be the other.
  for (const WdcnnParameter& parameter : pair.native.layout()) {
    const auto ours = unfolded<TypeParam>(parameter, pair.native.values());
    const auto gradient =
        numbers<TypeParam>(pair.libtorch.parameters()[parameter.spec.name].grad());
    const auto theirs = numbers<TypeParam>(pair.libtorch.parameters()[parameter.spec.name]);
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

TEST(WdcnnNetwork, TenUpdatesEqualLibtorchs) {
  Pair<double> pair(1024);
  for (int i = 0; i < 10; ++i) {
    BatchOutcome outcome;
    pair.propagate(random_batch(8, 1024, std::to_string(i)), outcome);
    pair.step();
  }
  pair.expect_equal_values(1e-8);
}

TEST(WdcnnNetwork, GradientEqualsFiniteDifferences) {
  Pair<double> pair(1024);
  WdcnnNetwork<double>& network = pair.native;
  const Batch batch = random_batch(6, 1024, "windows");
  const auto loss = [&] {
    network.forward(batch.windows, WdcnnNetwork<double>::Mode::training);
    return network.backward(batch.labels).loss / 6;
  };
  loss();
  const std::vector<double> gradients(network.gradients().begin(), network.gradients().end());
  constexpr double step = 1e-6;
  Stream stream("parameters");
  for (const WdcnnParameter& parameter : network.layout()) {
    std::vector<std::int64_t> places;
    parameter.for_each([&](std::int64_t, std::int64_t j) { places.push_back(j); });
    for (int sample = 0; sample < 4; ++sample) {
      const auto j = static_cast<std::size_t>(places[stream.below(places.size())]);
      double& value = network.values()[j];
      const double before = value;
      value = before + step;
      const double above = loss();
      value = before - step;
      const double below = loss();
      value = before;
      EXPECT_NEAR(gradients[j], (above - below) / (2 * step), 1e-7 + 1e-5 * std::abs(gradients[j]))
          << parameter.spec.name;
    }
  }
}

TEST(WdcnnNetwork, WhatFillsVectorsStaysZero) {
  Pair<float> pair(1024);
  BatchOutcome outcome;
  for (int i = 0; i < 3; ++i) {
    pair.propagate(random_batch(8, 1024, std::to_string(i)), outcome);
    pair.native_adam.step(pair.native.values().data(), pair.native.gradients().data(), 1e-2);
  }
  std::vector<bool> used(pair.native.values().size(), false);
  for (const WdcnnParameter& parameter : pair.native.layout()) {
    parameter.for_each(
        [&](std::int64_t, std::int64_t j) { used[static_cast<std::size_t>(j)] = true; });
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), true), 41370);  // WdcnnNetwork.NumberOfParameters
  for (std::size_t j = 0; j < used.size(); ++j) {
    if (!used[j]) {
      ASSERT_EQ(pair.native.values()[j], 0) << j;
    }
  }
}

TEST(WdcnnNetwork, EvaluationTreatsWindowsAloneAndKeepsItsState) {
  Pair<float> pair(1024);
  const Batch batch = random_batch(5, 1024, "windows");
  pair.native_logits(batch, true);
  const std::vector<float> mean(pair.native.running_mean(3).begin(),
                                pair.native.running_mean(3).end());
  const std::vector<double> together = pair.native_logits(batch, false);
  Batch third = batch;
  third.windows = {batch.windows[2]};
  EXPECT_EQ(pair.native_logits(third, false),
            std::vector(together.begin() + 2 * classes, together.begin() + 3 * classes));
  const auto mean_after = pair.native.running_mean(3);
  EXPECT_EQ(std::vector(mean_after.begin(), mean_after.end()), mean);
}

TEST(WdcnnNetwork, NanReachesTheLoss) {
  for (const char* name : {"conv1/weight", "conv5/weight", "conv3/scale", "dense/shift"}) {
    Pair<float> pair(1024);
    const Batch batch = random_batch(4, 1024, "windows");
    for (const WdcnnParameter& parameter : pair.native.layout()) {
      if (parameter.spec.name == name) {
        pair.native.values()[static_cast<std::size_t>(parameter.begin)] = std::nanf("");
      }
    }
    pair.native_logits(batch, true);
    EXPECT_TRUE(std::isnan(pair.native.backward(batch.labels).loss)) << name;
    EXPECT_TRUE(std::isnan(pair.native_logits(batch, false).front())) << name;
  }
}

}  // namespace
}  // namespace piae::diagnosis

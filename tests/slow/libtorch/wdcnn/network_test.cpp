#include "libtorch/wdcnn/network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "diagnosis/plain_wdcnn.hpp"
#include "libtorch/nets/torch.hpp"
#include "support/differences.hpp"

namespace piae::libtorch {
namespace {

using Mode = WdcnnNetwork::Mode;

constexpr std::int64_t classes = 10;

WdcnnNetwork double_network(std::int64_t length = 1024) {
  return {length, classes, Stream("network"), torch::kFloat64};
}

torch::Tensor random_windows(std::int64_t n, std::int64_t length = 1024) {
  Stream stream("windows");
  torch::Tensor windows = torch::empty({n, length}, torch::kFloat64);
  for (std::int64_t i = 0; i < windows.numel(); ++i) {
    windows.data_ptr<double>()[i] = stream.normal(0, 1);
  }
  return windows;
}

/// Sets scales and shifts of batch normalisation to values other than 1 and 0, so that they have an
/// effect.
void perturb_normalisation(WdcnnNetwork& network) {
  const torch::NoGradGuard no_grad;
  for (const char* layer : {"conv1", "conv2", "conv3", "conv4", "conv5", "dense"}) {
    for (const char* which : {"/scale", "/shift"}) {
      torch::Tensor p = network.parameters()[std::string(layer) + which];
      p.add_(0.3 * torch::cos(torch::arange(p.numel(), torch::kFloat64)));
    }
  }
}

TEST(WdcnnNetwork, HasThePublishedShapesLayerByLayer) {
  WdcnnNetwork network(1024, classes, Stream("network"));
  const std::vector<std::vector<std::int64_t>> expected{
      {2, 16, 32}, {2, 32, 16}, {2, 64, 8}, {2, 64, 4}, {2, 64, 1}};
  torch::Tensor x = torch::randn({2, 1, 1024});
  for (std::size_t i = 0; i < expected.size(); ++i) {
    x = network.convolve(i, x, Mode::training);
    EXPECT_EQ(x.sizes().vec(), expected[i]) << "convolution " << i;
  }
  EXPECT_EQ(network.forward(torch::randn({2, 1024}), Mode::training).sizes().vec(),
            (std::vector<std::int64_t>{2, classes}));
}

TEST(WdcnnNetwork, HasThePublishedNumberOfParameters) {
  WdcnnNetwork network(1024, classes, Stream("network"));
  constexpr int convolutions = 16 * 64 + 32 * 16 * 3 + 64 * 32 * 3 + 2 * 64 * 64 * 3;
  constexpr int normalisations = 2 * (16 + 32 + 64 + 64 + 64 + 100);
  constexpr int dense = 64 * 100 + 100 * 10 + 10;
  EXPECT_EQ(network.parameters().values().numel(), convolutions + normalisations + dense);
  EXPECT_EQ(network.parameters().values().numel(), 41370);
  // 2048 samples, as in Zhang et al.: 192 features reach the dense layer.
  WdcnnNetwork longer(2048, classes, Stream("network"));
  EXPECT_EQ(longer.parameters()["dense/weight"].sizes().vec(),
            (std::vector<std::int64_t>{100, 192}));
}

double at(const torch::Tensor& t, std::int64_t i) {
  return t.detach().contiguous().data_ptr<double>()[i];
}

std::vector<double> numbers(const torch::Tensor& t) {
  const torch::Tensor flat = t.detach().contiguous();
  return {flat.data_ptr<double>(), flat.data_ptr<double>() + flat.numel()};
}

std::vector<std::vector<double>> rows_of(const torch::Tensor& windows) {
  std::vector<std::vector<double>> rows;
  for (std::int64_t i = 0; i < windows.size(0); ++i) rows.push_back(numbers(windows[i]));
  return rows;
}

std::vector<double> by_plain_loops(WdcnnNetwork& network, const torch::Tensor& windows,
                                   bool running) {
  return diagnosis::plain::logits(
      {.parameter = [&](const std::string& name) { return numbers(network.parameters()[name]); },
       .mean = [&](std::size_t i) { return numbers(network.running(i).mean); },
       .variance = [&](std::size_t i) { return numbers(network.running(i).variance); }},
      rows_of(windows), classes, running);
}

void expect_equal(const std::vector<double>& ours, const torch::Tensor& theirs) {
  ASSERT_EQ(static_cast<std::int64_t>(ours.size()), theirs.numel());
  for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_NEAR(ours[i], at(theirs, i), 1e-10);
}

TEST(WdcnnNetwork, ForwardPassEqualsPlainLoops) {
  WdcnnNetwork network = double_network();
  perturb_normalisation(network);
  const torch::Tensor windows = random_windows(3);
  expect_equal(by_plain_loops(network, windows, false), network.forward(windows, Mode::training));
  // The pass above moved the running statistics away from 0 and 1.
  expect_equal(by_plain_loops(network, windows, true), network.forward(windows, Mode::evaluation));
}

TEST(WdcnnNetwork, ForwardPassEqualsPlainLoopsWithARemainderInPooling) {
  constexpr std::int64_t length = 1040;  // 65 values after the first convolution
  WdcnnNetwork network = double_network(length);
  const torch::Tensor windows = random_windows(3, length);
  expect_equal(by_plain_loops(network, windows, false), network.forward(windows, Mode::training));
}

TEST(WdcnnNetwork, RunningStatisticsFollowTheClosedForm) {
  WdcnnNetwork network = double_network();
  const torch::Tensor windows = random_windows(4);
  const auto expected = diagnosis::plain::first_convolution_statistics(
      numbers(network.parameters()["conv1/weight"]), rows_of(windows));
  constexpr int passes = 3;
  for (int i = 0; i < passes; ++i) network.forward(windows, Mode::training);
  const double kept = std::pow(0.9, passes);
  for (std::size_t c = 0; c < expected.size(); ++c) {
    const auto i = static_cast<std::int64_t>(c);
    EXPECT_NEAR(at(network.running(0).mean, i), (1 - kept) * expected[c].mean, 1e-12);
    EXPECT_NEAR(at(network.running(0).variance, i), kept + (1 - kept) * expected[c].variance,
                1e-12);
  }
}

TEST(WdcnnNetwork, EvaluationTreatsEachWindowAloneAndKeepsTheState) {
  WdcnnNetwork network = double_network();
  const torch::Tensor windows = random_windows(5);
  network.forward(windows, Mode::training);
  const torch::Tensor mean = network.running(3).mean.clone();
  const torch::Tensor together = network.forward(windows, Mode::evaluation);
  const torch::Tensor alone = network.forward(windows.slice(0, 2, 3), Mode::evaluation);
  EXPECT_TRUE(torch::allclose(together.slice(0, 2, 3), alone, 0, 1e-12));
  EXPECT_TRUE(torch::equal(network.running(3).mean, mean));
}

TEST(WdcnnNetwork, GradientEqualsFiniteDifferences) {
  WdcnnNetwork network = double_network();
  perturb_normalisation(network);
  const torch::Tensor windows = random_windows(6);
  const torch::Tensor labels = torch::arange(6, torch::kInt64);
  const auto loss = [&] {
    return torch::cross_entropy_loss(network.forward(windows, Mode::training), labels);
  };
  loss().backward();
  const torch::NoGradGuard no_grad;
  Stream stream("parameters");
  for (const torch::Tensor& parameter : network.parameters().with_prefix("")) {
    for (int sample = 0; sample < 4; ++sample) {
      const std::size_t i = stream.below(static_cast<std::size_t>(parameter.numel()));
      const double slope = central_difference(parameter.data_ptr<double>()[i], 1e-6,
                                              [&] { return loss().item<double>(); });
      const double gradient = at(parameter.grad(), static_cast<std::int64_t>(i));
      EXPECT_NEAR(gradient, slope, 1e-7 + 1e-5 * std::abs(gradient));
    }
  }
  EXPECT_GT(network.parameters().gradients().norm().item<double>(), 0.1);
}

}  // namespace
}  // namespace piae::libtorch

// The network for one core against plain loops and finite differences, both in double precision.

#include "diagnosis/wdcnn_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "diagnosis/expect_slopes.hpp"
#include "diagnosis/plain_wdcnn.hpp"
#include "diagnosis/random_batch.hpp"
#include "nets/adam.hpp"

namespace piae::diagnosis {
namespace {

constexpr std::int64_t classes = 10;

RandomBatch batch_of(std::int64_t n, std::int64_t length = 1024,
                     const std::string& name = "windows") {
  return random_batch(n, length, classes, name);
}

/// Scales and shifts of batch normalisation differ from 1 and 0, so that they matter; some scales
/// are negative.
template <class T>
WdcnnNetwork<T> example_network(std::int64_t length = 1024) {
  WdcnnNetwork<T> network(length, classes, 12, Stream("network"));
  for (const WdcnnParameter& parameter : network.layout()) {
    if (parameter.spec.shape.size() != 1) continue;
    parameter.for_each([&](std::int64_t i, std::int64_t j) {
      network.values()[static_cast<std::size_t>(j)] +=
          static_cast<T>(1.2 * std::cos(static_cast<double>(i)));
    });
  }
  return network;
}

template <class T>
std::vector<double> logits(WdcnnNetwork<T>& network, const RandomBatch& batch, bool training) {
  using Mode = typename WdcnnNetwork<T>::Mode;
  const T* row = network.forward(batch.windows, training ? Mode::training : Mode::evaluation);
  std::vector<double> all;
  for (std::size_t i = 0; i < batch.windows.size(); ++i, row += network.logits_row()) {
    all.insert(all.end(), row, row + classes);
  }
  return all;
}

std::vector<double> numbers(WdcnnNetwork<double>& network, const std::string& name) {
  for (const WdcnnParameter& parameter : network.layout()) {
    if (parameter.spec.name == name) return unfolded<double>(parameter, network.values());
  }
  ADD_FAILURE() << "no parameter " << name;
  return {};
}

std::vector<std::vector<double>> rows_of(const RandomBatch& batch) {
  std::vector<std::vector<double>> rows;
  for (const float* window : batch.windows) rows.emplace_back(window, window + batch.length);
  return rows;
}

/// Returns the numbers without the vectors' padding.
std::vector<double> channels(std::span<const double> held, std::size_t count) {
  return {held.begin(), held.begin() + static_cast<std::ptrdiff_t>(count)};
}

std::vector<double> by_plain_loops(WdcnnNetwork<double>& network, const RandomBatch& batch,
                                   bool running) {
  constexpr std::size_t outputs[] = {16, 32, 64, 64, 64, 100};
  return plain::logits(
      {.parameter = [&](const std::string& name) { return numbers(network, name); },
       .mean = [&](std::size_t i) { return channels(network.running_mean(i), outputs[i]); },
       .variance =
           [&](std::size_t i) { return channels(network.running_variance(i), outputs[i]); }},
      rows_of(batch), classes, running);
}

TEST(WdcnnNetwork, GivesTheLogitsOfPlainLoops) {
  for (const std::int64_t length : {1024, 1040}) {  // 1040: pooling ignores the last time
    WdcnnNetwork<double> network = example_network<double>(length);
    const RandomBatch batch = batch_of(3, length);
    expect_near(logits(network, batch, true), by_plain_loops(network, batch, false), 1e-12,
                "training");
    // The training pass has moved the running statistics away from 0 and 1.
    expect_near(logits(network, batch, false), by_plain_loops(network, batch, true), 1e-12,
                "evaluation");
  }
}

TEST(WdcnnNetwork, RunningStatisticsFollowTheClosedForm) {
  WdcnnNetwork<double> network = example_network<double>();
  const RandomBatch batch = batch_of(4);
  const auto expected =
      plain::first_convolution_statistics(numbers(network, "conv1/weight"), rows_of(batch));
  constexpr int passes = 3;
  for (int i = 0; i < passes; ++i) logits(network, batch, true);
  const double kept = std::pow(0.9, passes);
  for (std::size_t c = 0; c < expected.size(); ++c) {
    EXPECT_NEAR(network.running_mean(0)[c], (1 - kept) * expected[c].mean, 1e-12);
    EXPECT_NEAR(network.running_variance(0)[c], kept + (1 - kept) * expected[c].variance, 1e-12);
  }
}

TEST(WdcnnNetwork, LossIsTheCrossEntropyOfItsLogits) {
  WdcnnNetwork<double> network = example_network<double>();
  const RandomBatch batch = batch_of(6);
  const std::vector<double> all = logits(network, batch, true);
  double expected = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    double sum = 0;
    for (std::size_t c = 0; c < classes; ++c) sum += std::exp(all[i * classes + c]);
    expected += std::log(sum) - all[i * classes + static_cast<std::size_t>(batch.labels[i])];
  }
  EXPECT_NEAR(network.backward(batch.labels).loss, expected, 1e-12 * expected);
}

TEST(WdcnnNetwork, GradientEqualsFiniteDifferences) {
  WdcnnNetwork<double> network = example_network<double>();
  const RandomBatch batch = batch_of(6);
  const auto loss = [&] {
    network.forward(batch.windows, WdcnnNetwork<double>::Mode::training);
    return network.backward(batch.labels).loss / 6;
  };
  loss();
  expect_slopes(network, loss);
}

TEST(WdcnnNetwork, PaddingStaysZero) {
  WdcnnNetwork<float> network = example_network<float>();
  nets::Adam<float> adam(network.values().size());
  for (int i = 0; i < 3; ++i) {
    const RandomBatch batch = batch_of(8, 1024, std::to_string(i));
    logits(network, batch, true);
    network.backward(batch.labels);
    adam.step(network.values().data(), network.gradients().data(), 1e-2);
  }
  std::vector<bool> used(network.values().size(), false);
  for (const WdcnnParameter& parameter : network.layout()) {
    parameter.for_each(
        [&](std::int64_t, std::int64_t j) { used[static_cast<std::size_t>(j)] = true; });
  }
  constexpr int convolutions = 16 * 64 + 32 * 16 * 3 + 64 * 32 * 3 + 2 * 64 * 64 * 3;
  constexpr int normalisations = 2 * (16 + 32 + 64 + 64 + 64 + 100);
  constexpr int dense = 64 * 100 + 100 * 10 + 10;
  EXPECT_EQ(std::count(used.begin(), used.end(), true), convolutions + normalisations + dense);
  for (std::size_t j = 0; j < used.size(); ++j) {
    if (!used[j]) {
      ASSERT_EQ(network.values()[j], 0) << j;
    }
  }
}

TEST(WdcnnNetwork, EvaluationTreatsEachWindowAloneAndKeepsTheState) {
  WdcnnNetwork<float> network = example_network<float>();
  const RandomBatch batch = batch_of(5);
  logits(network, batch, true);
  const std::vector<float> mean(network.running_mean(3).begin(), network.running_mean(3).end());
  const std::vector<double> together = logits(network, batch, false);
  RandomBatch third = batch;
  third.windows = {batch.windows[2]};
  EXPECT_EQ(logits(network, third, false),
            std::vector(together.begin() + 2 * classes, together.begin() + 3 * classes));
  const auto mean_after = network.running_mean(3);
  EXPECT_EQ(std::vector(mean_after.begin(), mean_after.end()), mean);
}

TEST(WdcnnNetwork, NanReachesTheLoss) {
  for (const char* name : {"conv1/weight", "conv5/weight", "conv3/scale", "dense/shift"}) {
    WdcnnNetwork<float> network = example_network<float>();
    const RandomBatch batch = batch_of(4);
    for (const WdcnnParameter& parameter : network.layout()) {
      if (parameter.spec.name == name) {
        network.values()[static_cast<std::size_t>(parameter.begin)] = std::nanf("");
      }
    }
    logits(network, batch, true);
    EXPECT_TRUE(std::isnan(network.backward(batch.labels).loss)) << name;
    EXPECT_TRUE(std::isnan(logits(network, batch, false).front())) << name;
  }
}

}  // namespace
}  // namespace piae::diagnosis

#include "libtorch/wdcnn/network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "libtorch/nets/torch.hpp"

namespace piae::diagnosis {
namespace {

using Mode = WdcnnNetwork::Mode;
using Channels = std::vector<std::vector<double>>;  // [channels][samples]
using Batch = std::vector<Channels>;                // [n]

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

/// Scales and shifts of batch normalisation other than 1 and 0, so that they count.
void perturb_normalisation(WdcnnNetwork& network) {
  const torch::NoGradGuard no_grad;
  for (const char* layer : {"conv1", "conv2", "conv3", "conv4", "conv5", "dense"}) {
    for (const char* which : {"/scale", "/shift"}) {
      torch::Tensor p = network.parameters()[std::string(layer) + which];
      p.add_(0.3 * torch::cos(torch::arange(p.numel(), torch::kFloat64)));
    }
  }
}

TEST(WdcnnNetwork, ShapesLayerByLayer) {
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

TEST(WdcnnNetwork, NumberOfParameters) {
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

// ---- The same network in plain loops -------------------------------------------------------

double at(const torch::Tensor& t, std::int64_t i) {
  return t.detach().contiguous().data_ptr<double>()[i];
}

std::vector<double> numbers(const torch::Tensor& t) {
  const torch::Tensor flat = t.detach().contiguous();
  return {flat.data_ptr<double>(), flat.data_ptr<double>() + flat.numel()};
}

Channels convolved(const Channels& input, const std::vector<double>& weight, int outputs, int width,
                   int stride, int padding) {
  const int length = static_cast<int>(input[0].size());
  Channels output(outputs);
  for (int o = 0; o < outputs; ++o) {
    for (int begin = -padding; begin + width <= length + padding; begin += stride) {
      double sum = 0;
      for (int c = 0; c < static_cast<int>(input.size()); ++c) {
        for (int k = 0; k < width; ++k) {
          const int t = begin + k;
          if (t < 0 || t >= length) continue;
          sum += input[c][t] * weight[(o * static_cast<int>(input.size()) + c) * width + k];
        }
      }
      output[o].push_back(sum);
    }
  }
  return output;
}

/// Normalises each channel by given or, without any, by its own mean and biased variance.
void normalise(Batch& batch, const std::vector<double>& scale, const std::vector<double>& shift,
               const std::vector<double>& mean, const std::vector<double>& variance) {
  for (std::size_t c = 0; c < scale.size(); ++c) {
    double m = 0;
    double v = 0;
    if (mean.empty()) {
      double count = 0;
      for (const Channels& window : batch) {
        for (const double x : window[c]) m += x, ++count;
      }
      m /= count;
      for (const Channels& window : batch) {
        for (const double x : window[c]) v += (x - m) * (x - m) / count;
      }
    } else {
      m = mean[c];
      v = variance[c];
    }
    for (Channels& window : batch) {
      for (double& x : window[c]) x = (x - m) / std::sqrt(v + 1e-5) * scale[c] + shift[c];
    }
  }
}

void rectify(Batch& batch) {
  for (Channels& window : batch) {
    for (std::vector<double>& channel : window) {
      for (double& x : channel) x = std::max(x, 0.0);
    }
  }
}

void pool(Batch& batch) {
  for (Channels& window : batch) {
    for (std::vector<double>& channel : window) {
      std::vector<double> pooled;
      for (std::size_t t = 0; t + 1 < channel.size(); t += 2) {
        pooled.push_back(std::max(channel[t], channel[t + 1]));
      }
      channel = pooled;
    }
  }
}

Batch dense(const Batch& batch, const std::vector<double>& weight, std::size_t outputs) {
  Batch result;
  for (const Channels& window : batch) {
    Channels row(outputs, std::vector<double>(1));
    for (std::size_t o = 0; o < outputs; ++o) {
      for (std::size_t i = 0; i < window.size(); ++i) {
        row[o][0] += weight[o * window.size() + i] * window[i][0];
      }
    }
    result.push_back(row);
  }
  return result;
}

/// Logits [n, classes] in the order that the paper words: convolution, normalisation, ReLU,
/// pooling.
std::vector<double> by_loops(WdcnnNetwork& network, const torch::Tensor& windows, bool running) {
  struct Shape {
    int outputs, width, stride, padding;
  };
  const std::vector<Shape> shapes{
      {16, 64, 16, 24}, {32, 3, 1, 1}, {64, 3, 1, 1}, {64, 3, 1, 1}, {64, 3, 1, 0}};
  Batch batch;
  for (std::int64_t i = 0; i < windows.size(0); ++i) batch.push_back({numbers(windows[i])});
  const auto parameter = [&](const std::string& name) {
    return numbers(network.parameters()[name]);
  };
  const auto normalise_and_rectify = [&](std::size_t i, const std::string& layer) {
    const auto mean = running ? numbers(network.running(i).mean) : std::vector<double>{};
    normalise(batch, parameter(layer + "/scale"), parameter(layer + "/shift"), mean,
              numbers(network.running(i).variance));
    rectify(batch);
  };
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string layer = "conv" + std::to_string(i + 1);
    const Shape& s = shapes[i];
    for (Channels& window : batch) {
      window =
          convolved(window, parameter(layer + "/weight"), s.outputs, s.width, s.stride, s.padding);
    }
    normalise_and_rectify(i, layer);
    pool(batch);
  }
  batch = dense(batch, parameter("dense/weight"), 100);
  normalise_and_rectify(5, "dense");
  batch = dense(batch, parameter("classes/weight"), classes);
  std::vector<double> logits;
  const std::vector<double> bias = parameter("classes/bias");
  for (const Channels& window : batch) {
    for (std::size_t c = 0; c < classes; ++c) logits.push_back(window[c][0] + bias[c]);
  }
  return logits;
}

void expect_equal(const std::vector<double>& ours, const torch::Tensor& theirs) {
  ASSERT_EQ(static_cast<std::int64_t>(ours.size()), theirs.numel());
  for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_NEAR(ours[i], at(theirs, i), 1e-10);
}

TEST(WdcnnNetwork, ForwardPassEqualsPlainLoops) {
  WdcnnNetwork network = double_network();
  perturb_normalisation(network);
  const torch::Tensor windows = random_windows(3);
  expect_equal(by_loops(network, windows, false), network.forward(windows, Mode::training));
  // The pass above has moved the running statistics away from 0 and 1.
  expect_equal(by_loops(network, windows, true), network.forward(windows, Mode::evaluation));
}

TEST(WdcnnNetwork, ForwardPassWhereAValueIsLeftOverInPooling) {
  constexpr std::int64_t length = 1040;  // 65 values after the first convolution
  WdcnnNetwork network = double_network(length);
  const torch::Tensor windows = random_windows(3, length);
  expect_equal(by_loops(network, windows, false), network.forward(windows, Mode::training));
}

TEST(WdcnnNetwork, RunningStatisticsFollowTheClosedForm) {
  WdcnnNetwork network = double_network();
  const torch::Tensor windows = random_windows(4);
  const std::vector<double> weight = numbers(network.parameters()["conv1/weight"]);
  // Mean and unbiased variance of each channel over 4 windows of 64 values.
  std::vector<std::vector<double>> values(16);
  for (std::int64_t i = 0; i < 4; ++i) {
    const Channels filtered = convolved({numbers(windows[i])}, weight, 16, 64, 16, 24);
    for (int c = 0; c < 16; ++c) {
      ASSERT_EQ(filtered[c].size(), 64U);
      values[c].insert(values[c].end(), filtered[c].begin(), filtered[c].end());
    }
  }
  constexpr int passes = 3;
  for (int i = 0; i < passes; ++i) network.forward(windows, Mode::training);
  for (int c = 0; c < 16; ++c) {
    double mean = 0;
    for (const double x : values[c]) mean += x / 256;
    double variance = 0;
    for (const double x : values[c]) variance += (x - mean) * (x - mean) / 255;
    const double kept = std::pow(0.9, passes);
    EXPECT_NEAR(at(network.running(0).mean, c), (1 - kept) * mean, 1e-12);
    EXPECT_NEAR(at(network.running(0).variance, c), kept + (1 - kept) * variance, 1e-12);
  }
}

TEST(WdcnnNetwork, EvaluationTreatsWindowsAloneAndKeepsItsState) {
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
  constexpr double step = 1e-6;
  Stream stream("parameters");
  for (const torch::Tensor& parameter : network.parameters().with_prefix("")) {
    for (int sample = 0; sample < 4; ++sample) {
      const std::size_t i = stream.below(static_cast<std::size_t>(parameter.numel()));
      double& value = parameter.data_ptr<double>()[i];
      const double before = value;
      value = before + step;
      const double above = loss().item<double>();
      value = before - step;
      const double below = loss().item<double>();
      value = before;
      const double gradient = at(parameter.grad(), static_cast<std::int64_t>(i));
      EXPECT_NEAR(gradient, (above - below) / (2 * step), 1e-7 + 1e-5 * std::abs(gradient));
    }
  }
  EXPECT_GT(network.parameters().gradients().norm().item<double>(), 0.1);
}

}  // namespace
}  // namespace piae::diagnosis

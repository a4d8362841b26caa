#pragma once

// WDCNN in plain loops, as described in the paper: the reference for every implementation.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace piae::diagnosis::plain {

using Channels = std::vector<std::vector<double>>;  ///< [channels][samples]
using Batch = std::vector<Channels>;                ///< [n]

inline Channels convolved(const Channels& input, const std::vector<double>& weight, int outputs,
                          int width, int stride, int padding) {
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

/// Normalises each channel by the given mean and variance, or by its own (biased) if none are
/// given.
inline void normalise(Batch& batch, const std::vector<double>& scale,
                      const std::vector<double>& shift, const std::vector<double>& mean,
                      const std::vector<double>& variance) {
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

inline void rectify(Batch& batch) {
  for (Channels& window : batch) {
    for (std::vector<double>& channel : window) {
      for (double& x : channel) x = std::max(x, 0.0);
    }
  }
}

inline void pool(Batch& batch) {
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

inline Batch dense(const Batch& batch, const std::vector<double>& weight, std::size_t outputs) {
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

/// Numbers of a network, each list in the order of its shape.
struct Network {
  std::function<std::vector<double>(const std::string& name)> parameter;
  /// Running statistics of batch normalisation i.
  std::function<std::vector<double>(std::size_t i)> mean;
  std::function<std::vector<double>(std::size_t i)> variance;
};

/// Returns logits [n, classes] of windows: convolution, normalisation, ReLU, pooling. Uses the
/// running statistics if `running`, otherwise those of the batch.
inline std::vector<double> logits(const Network& network,
                                  const std::vector<std::vector<double>>& windows,
                                  std::size_t classes, bool running) {
  struct Shape {
    int outputs, width, stride, padding;
  };
  const std::vector<Shape> shapes{
      {16, 64, 16, 24}, {32, 3, 1, 1}, {64, 3, 1, 1}, {64, 3, 1, 1}, {64, 3, 1, 0}};
  Batch batch;
  for (const std::vector<double>& window : windows) batch.push_back({window});
  const auto normalise_and_rectify = [&](std::size_t i, const std::string& layer) {
    const auto mean = running ? network.mean(i) : std::vector<double>{};
    normalise(batch, network.parameter(layer + "/scale"), network.parameter(layer + "/shift"), mean,
              network.variance(i));
    rectify(batch);
  };
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string layer = "conv" + std::to_string(i + 1);
    const Shape& s = shapes[i];
    for (Channels& window : batch) {
      window = convolved(window, network.parameter(layer + "/weight"), s.outputs, s.width, s.stride,
                         s.padding);
    }
    normalise_and_rectify(i, layer);
    pool(batch);
  }
  batch = dense(batch, network.parameter("dense/weight"), 100);
  normalise_and_rectify(5, "dense");
  batch = dense(batch, network.parameter("classes/weight"), classes);
  std::vector<double> result;
  const std::vector<double> bias = network.parameter("classes/bias");
  for (const Channels& window : batch) {
    for (std::size_t c = 0; c < classes; ++c) result.push_back(window[c][0] + bias[c]);
  }
  return result;
}

/// Mean and unbiased variance of a list.
struct Statistics {
  double mean = 0;
  double variance = 0;
};

inline Statistics statistics(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  Statistics result;
  for (const double x : values) result.mean += x / count;
  for (const double x : values) {
    result.variance += (x - result.mean) * (x - result.mean) / (count - 1);
  }
  return result;
}

/// Returns the statistics of each of the 16 channels after the first convolution, over all windows
/// and times.
inline std::vector<Statistics> first_convolution_statistics(
    const std::vector<double>& weight, const std::vector<std::vector<double>>& windows) {
  std::vector<std::vector<double>> values(16);
  for (const std::vector<double>& window : windows) {
    const Channels filtered = convolved({window}, weight, 16, 64, 16, 24);
    for (std::size_t c = 0; c < 16; ++c) {
      values[c].insert(values[c].end(), filtered[c].begin(), filtered[c].end());
    }
  }
  std::vector<Statistics> result;
  result.reserve(values.size());
  for (const std::vector<double>& channel : values) result.push_back(statistics(channel));
  return result;
}

}  // namespace piae::diagnosis::plain

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace piae::diagnosis {

/// A convolution along time. It has no bias, because the batch normalisation after it would remove
/// any constant.
struct Convolution {
  std::int64_t inputs;   ///< channels
  std::int64_t outputs;  ///< channels
  std::int64_t width;    ///< samples
  std::int64_t stride;   ///< samples
  std::int64_t padding;  ///< zeros at each end

  [[nodiscard]] constexpr std::int64_t output_length(std::int64_t length) const {
    return length + 2 * padding < width ? 0 : (length + 2 * padding - width) / stride + 1;
  }
  [[nodiscard]] constexpr std::int64_t fan_in() const { return inputs * width; }
};

/// WDCNN (Zhang et al. 2017, Table 2): five convolutions, each with batch normalisation, ReLU and
/// max-pooling; a dense layer with batch normalisation and ReLU; a dense layer to the classes.
struct WdcnnLayers {
  static constexpr std::array<Convolution, 5> convolutions{{
      {.inputs = 1, .outputs = 16, .width = 64, .stride = 16, .padding = 24},
      {.inputs = 16, .outputs = 32, .width = 3, .stride = 1, .padding = 1},
      {.inputs = 32, .outputs = 64, .width = 3, .stride = 1, .padding = 1},
      {.inputs = 64, .outputs = 64, .width = 3, .stride = 1, .padding = 1},
      {.inputs = 64, .outputs = 64, .width = 3, .stride = 1, .padding = 0},
  }};
  static constexpr std::int64_t pooling = 2;   ///< after each convolution, samples become one
  static constexpr std::int64_t hidden = 100;  ///< units of the dense layer
  /// The shortest window that leaves one sample after the last pooling.
  static constexpr std::int64_t shortest_window = 1024;

  /// Returns the number of values that reach the dense layer for a window of `length` samples: 64
  /// for 1024 samples, 192 for 2048 (the length in Zhang et al.), 0 for a window that is too short.
  [[nodiscard]] static constexpr std::int64_t features(std::int64_t length) {
    for (const Convolution& c : convolutions) length = c.output_length(length) / pooling;
    return length * convolutions.back().outputs;
  }
};

/// Constants of batch normalisation, as in PyTorch: the biased variance of a batch normalises the
/// batch, and the unbiased one enters the running statistics.
struct BatchNormalisation {
  static constexpr double epsilon = 1e-5;
  static constexpr double momentum = 0.1;  ///< weight of the newest batch in the running statistics
};

static_assert(WdcnnLayers::features(WdcnnLayers::shortest_window) == 64);
static_assert(WdcnnLayers::features(WdcnnLayers::shortest_window - 1) == 0);

}  // namespace piae::diagnosis

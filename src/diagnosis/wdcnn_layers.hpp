#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace piae::diagnosis {

/// A convolution along time. Each is followed by batch normalisation, which takes any constant out
/// again, and so it has no bias.
struct Convolution {
  std::int64_t inputs;   ///< channels
  std::int64_t outputs;  ///< channels
  std::int64_t width;    ///< samples
  std::int64_t stride;   ///< samples
  std::int64_t padding;  ///< zeros at either end

  [[nodiscard]] constexpr std::int64_t output_length(std::int64_t length) const {
    return length + 2 * padding < width ? 0 : (length + 2 * padding - width) / stride + 1;
  }
  [[nodiscard]] constexpr std::int64_t fan_in() const { return inputs * width; }
};

/// WDCNN (Zhang et al. 2017, Table 2): five convolutions, each with batch normalisation, ReLU and
/// max-pooling; a dense layer with batch normalisation and ReLU; a dense layer to the classes.
struct WdcnnLayers {
  static constexpr std::array<Convolution, 5> convolutions{{
      {1, 16, 64, 16, 24},
      {16, 32, 3, 1, 1},
      {32, 64, 3, 1, 1},
      {64, 64, 3, 1, 1},
      {64, 64, 3, 1, 0},
  }};
  static constexpr std::int64_t pooling = 2;   ///< samples to one, after each convolution
  static constexpr std::int64_t hidden = 100;  ///< units of the dense layer
  /// The shortest window that leaves one sample after the last pooling.
  static constexpr std::int64_t shortest_window = 1024;

  /// Values that reach the dense layer: 64 for a window of 1024 samples, 192 for one of 2048 (the
  /// length in Zhang et al.), 0 for one that is too short.
  [[nodiscard]] static constexpr std::int64_t features(std::int64_t length) {
    for (const Convolution& c : convolutions) length = c.output_length(length) / pooling;
    return length * convolutions.back().outputs;
  }
};

/// Batch normalisation as in PyTorch: biased variance within the batch, unbiased in the running
/// statistics.
struct BatchNormalisation {
  static constexpr double epsilon = 1e-5;
  static constexpr double momentum = 0.1;  ///< weight of the newest batch in running statistics
};

static_assert(WdcnnLayers::features(WdcnnLayers::shortest_window) == 64);
static_assert(WdcnnLayers::features(WdcnnLayers::shortest_window - 1) == 0);

}  // namespace piae::diagnosis

#pragma once

#include <algorithm>

#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// Transposes each sequence, [length, width] -> [width, length]: a convolution stores all channels
/// of a position together, while the neighbouring dense layer stores one channel after the other.
template <class T>
class Transposition final : public SequenceLayer<T> {
 public:
  explicit Transposition(const SequenceShape& input)
      : SequenceLayer<T>(input, {.length = input.width, .width = input.length}) {}

  void forward(std::int64_t windows, const T* x, T* y) override {
    for (std::int64_t w = 0; w < windows; ++w) transpose(this->input(), x, y, w);
  }

  void backward(const SignalBatch& batch, const T*, const T* dy, T* dx) override {
    if (dx == nullptr) return;
    for (std::int64_t w = 0; w < batch.all(); ++w) transpose(this->output(), dy, dx, w);
  }

 private:
  /// Copies square by square, so that reads and writes both stay in the cache.
  static void transpose(const SequenceShape& shape, const T* all_from, T* all_to,
                        std::int64_t window) {
    constexpr std::int64_t square = 16;
    const auto [height, width] = shape;
    const T* const from = all_from + window * shape.size();
    T* const to = all_to + window * shape.size();
    for (std::int64_t top = 0; top < height; top += square) {
      for (std::int64_t left = 0; left < width; left += square) {
        for (std::int64_t i = top; i < std::min(top + square, height); ++i) {
          for (std::int64_t j = left; j < std::min(left + square, width); ++j) {
            to[j * height + i] = from[i * width + j];
          }
        }
      }
    }
  }
};

}  // namespace piae::nets

#pragma once

#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// Averages all positions: [length, width] -> [1, width].
template <class T>
class PositionMean final : public SequenceLayer<T> {
 public:
  explicit PositionMean(const SequenceShape& input)
      : SequenceLayer<T>(input, {.length = 1, .width = input.width}) {}

  void forward(std::int64_t windows, const T* x, T* y) override {
    const auto [length, width] = this->input();
    for (std::int64_t w = 0; w < windows; ++w) {
      as_matrix(y + w * width, 1, width) =
          as_matrix(x + w * length * width, length, width).colwise().mean();
    }
  }

  void backward(const SignalBatch& batch, const T*, const T* dy, T* dx) override {
    if (dx == nullptr) return;
    const auto [length, width] = this->input();
    for (std::int64_t w = 0; w < batch.all(); ++w) {
      as_matrix(dx + w * length * width, length, width).rowwise() =
          as_matrix(dy + w * width, 1, width).row(0) / static_cast<T>(length);
    }
  }
};

}  // namespace piae::nets

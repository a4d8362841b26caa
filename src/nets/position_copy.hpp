#pragma once

#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// Repeats one position: [1, width] -> [length, width].
template <class T>
class PositionCopy final : public SequenceLayer<T> {
 public:
  explicit PositionCopy(const SequenceShape& output)
      : SequenceLayer<T>({.length = 1, .width = output.width}, output) {}

  void forward(std::int64_t windows, const T* x, T* y) override {
    const auto [length, width] = this->output();
    for (std::int64_t w = 0; w < windows; ++w) {
      as_matrix(y + w * length * width, length, width).rowwise() =
          as_matrix(x + w * width, 1, width).row(0);
    }
  }

  void backward(const SignalBatch& batch, const T*, const T* dy, T* dx) override {
    if (dx == nullptr) return;
    const auto [length, width] = this->output();
    for (std::int64_t w = 0; w < batch.all(); ++w) {
      as_matrix(dx + w * width, 1, width) =
          as_matrix(dy + w * length * width, length, width).colwise().sum();
    }
  }
};

}  // namespace piae::nets

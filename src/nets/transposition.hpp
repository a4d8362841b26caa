#pragma once

#include "base/transpose.hpp"
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
    for (std::int64_t w = 0; w < windows; ++w) transpose_window(this->input(), x, y, w);
  }

  void backward(const SignalBatch& batch, const T*, const T* dy, T* dx) override {
    if (dx == nullptr) return;
    for (std::int64_t w = 0; w < batch.all(); ++w) transpose_window(this->output(), dy, dx, w);
  }

 private:
  static void transpose_window(const SequenceShape& shape, const T* from, T* to,
                               std::int64_t window) {
    transpose(shape.length, shape.width, from + window * shape.size(), to + window * shape.size());
  }
};

}  // namespace piae::nets

#pragma once

#include <algorithm>

#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// Returns only the last position: [length, width] -> [1, width].
template <class T>
class LastPosition final : public SequenceLayer<T> {
 public:
  explicit LastPosition(const SequenceShape& input)
      : SequenceLayer<T>(input, {.length = 1, .width = input.width}) {}

  void forward(std::int64_t windows, const T* x, T* y) override {
    const auto [length, width] = this->input();
    for (std::int64_t w = 0; w < windows; ++w) {
      std::copy_n(x + ((w + 1) * length - 1) * width, width, y + w * width);
    }
  }

  void backward(const SignalBatch& batch, const T*, const T* dy, T* dx) override {
    if (dx == nullptr) return;
    const auto [length, width] = this->input();
    for (std::int64_t w = 0; w < batch.all(); ++w) {
      T* const last = dx + ((w + 1) * length - 1) * width;
      std::fill(dx + w * length * width, last, T{0});
      std::copy_n(dy + w * width, width, last);
    }
  }
};

}  // namespace piae::nets

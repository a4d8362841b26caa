#pragma once

#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// Computes max(x, 0) of each number.
template <class T>
class Relu final : public SequenceLayer<T> {
 public:
  explicit Relu(const SequenceShape& shape) : SequenceLayer<T>(shape, shape) {}

  void forward(std::int64_t windows, const T* x, T* y) override {
    const std::int64_t size = windows * this->input().size();
    as_matrix(y, 1, size) = as_matrix(x, 1, size).cwiseMax(T{0});
  }

  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override {
    if (dx == nullptr) return;
    const std::int64_t size = batch.windows * this->input().size();
    for (std::int64_t signal = 0; signal < batch.signals; ++signal) {
      as_matrix(dx + signal * size, 1, size) =
          (as_matrix(x, 1, size).array() > T{0})
              .select(as_matrix(dy + signal * size, 1, size).array(), T{0});
    }
  }
};

}  // namespace piae::nets

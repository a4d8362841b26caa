#pragma once

#include <memory>
#include <utility>

#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// Adds the input to a layer's output: y = x + F(x) (He et al. 2016).
template <class T>
class Residual final : public SequenceLayer<T> {
 public:
  /// The shapes of the layer's input and output must be equal.
  explicit Residual(std::unique_ptr<SequenceLayer<T>> branch)
      : SequenceLayer<T>(branch->input(), branch->output()), branch_(std::move(branch)) {}

  void forward(std::int64_t windows, const T* x, T* y) override {
    branch_->forward(windows, x, y);
    const std::int64_t size = windows * this->input().size();
    as_matrix(y, 1, size) += as_matrix(x, 1, size);
  }

  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override {
    branch_->backward(batch, x, dy, dx);
    const std::int64_t size = batch.all() * this->input().size();
    if (dx != nullptr) as_matrix(dx, 1, size) += as_matrix(dy, 1, size);
  }

 private:
  std::unique_ptr<SequenceLayer<T>> branch_;
};

}  // namespace piae::nets

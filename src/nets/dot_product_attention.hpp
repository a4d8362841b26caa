#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// Scaled dot-product attention with several heads (Vaswani et al. 2017, eq. 1) within each window.
/// A position brings queries, keys and values side by side, [3 * width], each head's part of them
/// side by side too: y = softmax(Q K^T / sqrt(width / heads)) V, head by head. It has no
/// parameters; the projections before and after it are dense layers.
template <class T>
class DotProductAttention final : public SequenceLayer<T> {
 public:
  /// The width must be whole rows and a multiple of the heads.
  DotProductAttention(const SequenceShape& output, std::int64_t heads);

  void forward(std::int64_t windows, const T* x, T* y) override;
  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override;

 private:
  std::int64_t heads_;
  std::int64_t head_;  ///< numbers of a head
  /// Of a row of attention, which begins at the boundary of a vector register: where it does
  /// decides in which order Eigen sums it, and that must not depend on the window's place.
  std::int64_t held_length_;
  T factor_;                    ///< 1 / sqrt(head_)
  Eigen::ArrayX<T> attention_;  ///< [windows, heads, length, held length]
  RowMatrix<T> by_attention_;   ///< of one window and head
};

extern template class DotProductAttention<float>;
extern template class DotProductAttention<double>;

}  // namespace piae::nets

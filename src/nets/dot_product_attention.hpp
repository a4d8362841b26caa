#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// Scaled dot-product attention with several heads (Vaswani et al. 2017, eq. 1) within each window.
/// The input of a position is queries, keys and values, [3 * width], each divided into the parts of
/// the heads. Computes y = softmax(Q K^T / sqrt(width / heads)) V for each head. It has no
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
  std::int64_t head_;  ///< width of a head
  /// Length of a padded row of attention. Each row starts at the boundary of a vector register: the
  /// start decides Eigen's order of summation, which must not depend on the window's position.
  std::int64_t held_length_;
  T factor_;                    ///< 1 / sqrt(head_)
  Eigen::ArrayX<T> attention_;  ///< [windows, heads, length, held length]
  RowMatrix<T> by_attention_;   ///< for one window and head
};

extern template class DotProductAttention<float>;
extern template class DotProductAttention<double>;

}  // namespace piae::nets

#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "nets/gradient_array.hpp"

namespace piae::nets {

/// The products of a weight W [outputs, held inputs] with rows of numbers. Each number is summed in
/// an order that does not depend on how many rows there are, so that what a window gives does not
/// depend on the windows beside it. Rows of inputs and of outputs are filled up with zeros to whole
/// rows.
template <class T>
class WeightProducts {
 public:
  explicit WeightProducts(const TrainedParameter<T>& weight);

  /// From one row of outputs to the next.
  [[nodiscard]] std::int64_t held_outputs() const { return held_outputs_; }

  /// y = x W^T.
  void forward(std::int64_t rows, const T* x, T* y);
  /// The gradient of the weight becomes dy^T x.
  void differentiate(std::int64_t rows, const T* x, const T* dy) const;
  /// dx = dy W.
  void backward(std::int64_t rows, const T* dy, T* dx) const;

 private:
  TrainedParameter<T> weight_;
  std::int64_t held_outputs_;
  Eigen::ArrayX<T> transposed_;  ///< W^T, [held inputs, held outputs]
};

extern template class WeightProducts<float>;
extern template class WeightProducts<double>;

}  // namespace piae::nets

#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "nets/gradient_array.hpp"
#include "nets/rows.hpp"

namespace piae::nets {

/// The products of a weight W [outputs, inputs] with rows of numbers, where the gradient of the
/// weight is stored (gradient_array.hpp). Each number is summed in an order that does not depend on
/// how many rows there are, so that what a window gives does not depend on the windows beside it.
/// Rows of inputs and of outputs are filled up with zeros to whole rows.
///
/// Weights that are so large that a step waits for memory are dense_kernels.hpp's: these read a
/// weight as it is stored, and never store its gradient.
template <class T>
class WeightProducts {
 public:
  explicit WeightProducts(const TrainedParameter<T>& weight);

  /// Takes over the weight as it is now, in the order in which forward() reads it.
  void renew();
  /// y = x W^T, with the weight of the last renew().
  void forward(std::int64_t rows, Rows<const T> x, Rows<T> y) const;
  /// The gradient of the weight becomes dy^T x.
  void differentiate(std::int64_t rows, Rows<const T> x, Rows<const T> dy) const;
  /// dx = dy W, or dx += dy W.
  void backward(std::int64_t rows, Rows<const T> dy, Rows<T> dx, bool add = false) const;

 private:
  TrainedParameter<T> weight_;
  std::int64_t held_outputs_;
  Eigen::ArrayX<T> transposed_;  ///< W^T, [inputs, held outputs]
};

/// Adds a bias to each row of y [rows, width] without gaps.
template <class T>
void add_bias(const TrainedParameter<T>& bias, std::int64_t rows, std::int64_t width, T* y);
/// Its gradient becomes the sum of the rows of dy [rows, width].
template <class T>
void differentiate_bias(const TrainedParameter<T>& bias, std::int64_t rows, std::int64_t width,
                        const T* dy);

extern template class WeightProducts<float>;
extern template class WeightProducts<double>;

}  // namespace piae::nets

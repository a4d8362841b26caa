#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "nets/gradient_array.hpp"
#include "nets/rows.hpp"

namespace piae::nets {

/// The products of a weight W [outputs, inputs] with rows of numbers, for stored weight gradients
/// (gradient_array.hpp). Each number is summed in an order that does not depend on the number of
/// rows, so that the result of a window does not depend on other windows. Rows of inputs and of
/// outputs are padded with zeros to whole rows.
///
/// For weights so large that a step waits for memory, use dense_kernels.hpp: it reads a weight as
/// stored and never stores its gradient.
template <class T>
class WeightProducts {
 public:
  explicit WeightProducts(const TrainedParameter<T>& weight);

  /// Copies the current weight into the order that forward() reads.
  void renew();
  /// y = x W^T, with the weight of the last renew().
  void forward(std::int64_t rows, Rows<const T> x, Rows<T> y) const;
  /// Sets the gradient of the weight to dy^T x.
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
/// Sets the gradient of a bias to the sum of the rows of dy [rows, width].
template <class T>
void differentiate_bias(const TrainedParameter<T>& bias, std::int64_t rows, std::int64_t width,
                        const T* dy);

extern template class WeightProducts<float>;
extern template class WeightProducts<double>;

}  // namespace piae::nets

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>

#include "nets/adam.hpp"
#include "nets/parameters.hpp"
#include "nets/rows.hpp"
#include "nets/strided_convolution.hpp"

namespace piae::nets {

enum class ConvolutionKind {
  strided,    ///< the output is the coarse side
  transposed  ///< the output is the fine side
};

/// A strided convolution, or a transposed one, with its parameters <name>/weight and <name>/bias.
/// The weight is [coarse channels, fine channels, kernel] in either. Batches are as
/// strided_convolution.hpp says.
template <class T>
class ConvolutionLayer {
 public:
  /// Throws std::logic_error for a weight of another form than StridedConvolution has, and for a
  /// length that the stride does not divide.
  ConvolutionLayer(std::shared_ptr<Parameters<T>> parameters, const std::string& name,
                   ConvolutionKind kind, std::int64_t input_length);

  [[nodiscard]] const StridedConvolution& shape() const { return shape_; }
  [[nodiscard]] std::int64_t output_length() const;
  [[nodiscard]] std::int64_t inputs() const;   ///< channels
  [[nodiscard]] std::int64_t outputs() const;  ///< channels

  void forward(std::int64_t rows, Rows<const T> input, Rows<T> output) const;
  /// From the gradient by the output to that by the input.
  void propagate_back(std::int64_t rows, Rows<const T> output_gradient,
                      Rows<T> input_gradient) const;

  /// Computes the gradients by the parameters, and keeps them.
  void differentiate(std::int64_t rows, Rows<const T> input, Rows<const T> output_gradient);
  /// The squared Euclidean norm of these.
  [[nodiscard]] double squared_norm() const;
  /// One step of Adam by these times `scale`.
  void take(const AdamStep& step, double scale);

 private:
  using Numbers = Eigen::ArrayX<T>;
  using Kept = typename Parameters<T>::Kept;

  [[nodiscard]] Rows<const T> weight() const {
    return {parameters_->data(Kept::value) + weight_begin_, held_columns_};
  }

  std::shared_ptr<Parameters<T>> parameters_;
  ConvolutionKind kind_;
  StridedConvolution shape_{};
  std::int64_t weight_begin_;   ///< in the array of all parameters
  std::int64_t bias_begin_;     ///< there
  std::int64_t held_columns_;   ///< of the weight
  Numbers gradient_by_weight_;  ///< as the weight is held
  Numbers gradient_by_bias_;    ///< as the bias is held
};

extern template class ConvolutionLayer<float>;
extern template class ConvolutionLayer<double>;

}  // namespace piae::nets

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "nets/gradient_array.hpp"
#include "nets/sequence_layer.hpp"
#include "nets/weight_products.hpp"

namespace piae::nets {

/// Returns the parameters of a layer of gated recurrent units: <name>/input_weight [3 units,
/// inputs], state_weight [3 units, units], input_bias and state_bias [3 units], in the order of
/// LibTorch's gru. Each contains the rows of the gates r, z and n (gru_gates.hpp), in this order.
std::vector<ParameterSpec> gru_specs(const std::string& name, std::int64_t inputs,
                                     std::int64_t units);

/// Gated recurrent units that process their input position by position, from the state 0: [length,
/// inputs] -> [length, units], the states after each position. The products with the inputs and
/// those of the gradients cover all positions at once. Only the product with the state is computed
/// position by position.
template <class T>
class GruLayer final : public SequenceLayer<T> {
 public:
  /// If `input_length` is 1, the same input applies at each of `length` positions; otherwise it
  /// must equal `length`. Throws std::logic_error for other lengths, and if the units are not whole
  /// rows.
  GruLayer(GradientArray<T>& parameters, const std::string& name, std::int64_t input_length,
           std::int64_t length);

  void forward(std::int64_t windows, const T* x, T* y) override;
  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override;

 private:
  using Numbers = Eigen::ArrayX<T>;  // starts at the boundary of a vector register

  [[nodiscard]] std::int64_t length() const { return this->output().length; }
  [[nodiscard]] std::int64_t units() const { return this->output().width; }
  /// Returns all windows at one position of an array [windows, length, width].
  template <class Number>
  Rows<Number> at(Number* numbers, std::int64_t position, std::int64_t width) const {
    return {numbers + position * width, length() * width};
  }
  /// Converts the gradients by the states to those by the inputs of the gates, position by
  /// position, into by_x_ and by_product_.
  void differentiate_states(const SignalBatch& batch, const T* dy);

  WeightProducts<T> input_weight_;
  WeightProducts<T> state_weight_;
  TrainedParameter<T> input_bias_;
  TrainedParameter<T> state_bias_;
  Numbers x_;        ///< [windows, input length, 3 units]: W_x input + b_x
  Numbers product_;  ///< [windows, 3 units]: W_h h at one position
  Numbers gates_;    ///< [windows, length, 4 units]: r, z, n and h_n
  Numbers before_;   ///< [windows, length, units]: the states before each position
  // For all signals:
  Numbers carried_;     ///< [windows, units]: the gradient by the state through later positions
  Numbers by_x_;        ///< [windows, length, 3 units]
  Numbers by_product_;  ///< [windows, length, 3 units]
};

extern template class GruLayer<float>;
extern template class GruLayer<double>;

}  // namespace piae::nets

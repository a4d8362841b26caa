#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "nets/dense_kernels.hpp"
#include "nets/parameters.hpp"

namespace piae::nets {

/// A chain of dense layers with ReLU between them (run_dense_chain of dense.hpp), trained on one
/// core by hand-written gradients. Batches are small and weights large, so a step is bound by
/// memory: gradients of weights, of the rank of the batch, are never stored (dense_kernels.hpp).
///
/// A step: fill input(); forward(); fill output_gradient() and backward(), which gives the gradient
/// by the input where it is asked for; squared_norm(), to clip; take().
template <class T>
class DenseChain {
 public:
  /// Of the parameters <name>/0/weight, <name>/0/bias, ..., which must outlive it, for batches of
  /// up to `most_rows` rows. Throws std::logic_error where there are none of that name, and later
  /// for more rows.
  DenseChain(Parameters<T>& parameters, const std::string& name, std::int64_t most_rows);
  // A copy of what holds both would have the parameters of another.
  DenseChain(const DenseChain&) = delete;
  DenseChain& operator=(const DenseChain&) = delete;

  /// [most_rows, inputs], to be filled; beyond the inputs it stays zero.
  Rows<T> input() { return rows_of(layers_.front().input, layers_.front().size.held_inputs); }
  /// [rows, outputs].
  Rows<const T> forward(std::int64_t rows);

  /// [most_rows, outputs], to be filled.
  Rows<T> output_gradient() { return output_gradient_of(layers_.back()); }
  struct RowRange {
    std::int64_t begin;
    std::int64_t count;
  };
  static constexpr RowRange no_rows{0, 0};
  /// Gradients by what the layers gave in forward(rows). More signals than one are gradients of
  /// several functions of the same batch, one below the other, [signals * rows, outputs]. Returns
  /// those by the input for a range of these rows.
  Rows<const T> backward(std::int64_t rows, std::int64_t signals, RowRange by_input);

  /// For the derivative of a gradient by the input, as a gradient penalty has it. For the rows
  /// [first, first + rows): takes what input() now holds there through the layers without biases,
  /// where the last forward() was above zero, and puts it in the place of what they were given.
  void forward_derivative(std::int64_t first, std::int64_t rows);

  /// Which rows the gradients of weights and of biases are summed over.
  struct Summed {
    std::int64_t of_weights;
    std::int64_t of_biases;
  };
  /// Of all gradients.
  [[nodiscard]] double squared_norm(const Summed& rows) const;
  /// One step of Adam by the gradients times `scale`.
  void take(const AdamStep& step, double scale, const Summed& rows);

 private:
  using Numbers = Eigen::ArrayX<T>;  // on the boundary of vectors
  struct Layer {
    LayerSize size;
    std::int64_t weight;  ///< where it begins in the flat vector
    std::int64_t bias;
    std::int64_t held_outputs;
    Numbers input;            ///< [most_rows, held inputs]
    Numbers output_gradient;  ///< [most_rows, held outputs]
  };
  using Kept = typename Parameters<T>::Kept;

  static Rows<T> rows_of(Numbers& numbers, std::int64_t stride) { return {numbers.data(), stride}; }
  static Rows<const T> rows_of(const Numbers& numbers, std::int64_t stride) {
    return {numbers.data(), stride};
  }
  static Rows<T> output_gradient_of(Layer& layer) {
    return rows_of(layer.output_gradient, layer.held_outputs);
  }
  static Rows<const T> output_gradient_of(const Layer& layer) {
    return rows_of(layer.output_gradient, layer.held_outputs);
  }
  [[nodiscard]] const T* values(std::int64_t begin) const {
    return parameters_.data(Kept::value) + begin;
  }
  void require_room_for(std::int64_t rows) const;
  [[nodiscard]] std::vector<T> bias_gradient(const Layer& layer, std::int64_t rows) const;

  Parameters<T>& parameters_;
  std::int64_t most_rows_;
  std::vector<Layer> layers_;
  Numbers output_;          ///< [most_rows, held outputs] of the last layer
  Numbers input_gradient_;  ///< [most_rows, held inputs] of the first layer
  std::vector<T> no_bias_;
};

extern template class DenseChain<float>;
extern template class DenseChain<double>;

}  // namespace piae::nets

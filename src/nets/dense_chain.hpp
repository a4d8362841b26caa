#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "nets/dense_kernels.hpp"
#include "nets/parameters.hpp"

namespace piae::nets {

/// A chain of dense layers with ReLU between them, trained on one core with gradients that are
/// written by hand. Batches are small and weights are large, so a step waits for memory. The
/// gradient of a weight is therefore never stored: it is a sum of as many outer products as the
/// batch has rows, and it is formed where it is used (dense_kernels.hpp).
///
/// A training step: fill input(); call forward(); fill output_gradient(); call backward(), which
/// returns the gradient by the input where that is asked for; call squared_norm() if the gradients
/// are to be clipped; call take().
template <class T>
class DenseChain {
 public:
  /// A chain over the parameters <name>/0/weight, <name>/0/bias, <name>/1/weight, ..., for batches
  /// of up to `most_rows` rows. Several chains may share one set of parameters. Throws
  /// std::logic_error when no parameter has such a name; later calls throw it for more rows.
  DenseChain(std::shared_ptr<Parameters<T>> parameters, const std::string& name,
             std::int64_t most_rows);
  // A copy would train the same parameters as the original, which nobody would expect.
  DenseChain(const DenseChain&) = delete;
  DenseChain& operator=(const DenseChain&) = delete;

  /// [most_rows, inputs]: the caller fills the rows of its batch. The numbers that fill a row up to
  /// whole vectors must stay zero.
  Rows<T> input() { return rows_of(layers_.front().input, layers_.front().size.held_inputs); }
  /// The output [rows, outputs] for the first `rows` rows of input().
  Rows<const T> forward(std::int64_t rows);

  /// [most_rows, outputs]: the caller fills in the gradient of its loss by the output.
  Rows<T> output_gradient() { return output_gradient_of(layers_.back()); }
  struct RowRange {
    std::int64_t begin;
    std::int64_t count;
  };
  static constexpr RowRange no_rows{.begin = 0, .count = 0};
  /// Propagates output_gradient() back through the layers, after forward(rows). With more than one
  /// signal, output_gradient() holds the gradients of several losses of the same batch, one below
  /// the other: [signals * rows, outputs]. Returns the gradients by the input for the rows
  /// `by_input` of these [signals * rows].
  Rows<const T> backward(std::int64_t rows, std::int64_t signals, RowRange by_input);

  /// The forward pass that the derivative of a gradient by the input needs, as a gradient penalty
  /// has it. For the rows [first, first + rows), it takes what input() now holds through the
  /// layers without their biases, and only through units that gave more than zero in the last
  /// forward(). The results replace the inputs of the layers that forward() left there.
  void forward_derivative(std::int64_t first, std::int64_t rows);

  /// Over how many of the first rows the gradients of weights and of biases are summed.
  struct Summed {
    std::int64_t of_weights;
    std::int64_t of_biases;
  };
  /// The squared Euclidean norm of the gradients of all weights and biases together.
  [[nodiscard]] double squared_norm(const Summed& rows) const;
  /// One step of Adam by the gradients times `scale`.
  void take(const AdamStep& step, double scale, const Summed& rows);

 private:
  using Numbers = Eigen::ArrayX<T>;  // begins at the boundary of a vector register
  struct Layer {
    LayerSize size;
    std::int64_t weight;  ///< where the weight begins in the array of all parameters
    std::int64_t bias;    ///< where the bias begins there
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
    return parameters_->data(Kept::value) + begin;
  }
  void require_room_for(std::int64_t rows) const;
  [[nodiscard]] std::vector<T> bias_gradient(const Layer& layer, std::int64_t rows) const;

  std::shared_ptr<Parameters<T>> parameters_;
  std::int64_t most_rows_;
  std::vector<Layer> layers_;
  Numbers output_;          ///< [most_rows, held outputs] of the last layer
  Numbers input_gradient_;  ///< [most_rows, held inputs] of the first layer
  std::vector<T> no_bias_;  ///< zeros, in the place of a bias
};

extern template class DenseChain<float>;
extern template class DenseChain<double>;

}  // namespace piae::nets

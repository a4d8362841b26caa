#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "nets/dense_kernels.hpp"
#include "nets/network.hpp"
#include "nets/parameters.hpp"

namespace piae::nets {

/// A chain of dense layers with ReLU between them. Batches are small and weights are large, so a
/// step waits for memory. Therefore the gradient of a weight is never stored: it is a sum of outer
/// products, one per row of the batch, and is computed where it is used (dense_kernels.hpp).
template <class T>
class DenseChain final : public Network<T> {
 public:
  /// Makes a chain over the parameters <name>/0/weight, <name>/0/bias, <name>/1/weight, ..., for
  /// batches of up to `most_rows` rows. Several chains may share one set of parameters. Throws
  /// std::logic_error if no parameter has such a name; later calls throw it for more rows.
  DenseChain(std::shared_ptr<Parameters<T>> parameters, const std::string& name,
             std::int64_t most_rows);

  Rows<T> input() override {
    return rows_of(layers_.front().input, layers_.front().size.held_inputs);
  }
  Rows<const T> forward(std::int64_t rows) override;
  Rows<T> output_gradient() override { return output_gradient_of(layers_.back()); }
  Rows<const T> backward(std::int64_t rows, std::int64_t signals, RowRange by_input) override;

  /// Does backward() for one signal and then take() with a scale of 1, in one pass over the
  /// weights. Use it if the norm of the gradients is not needed in between. Returns the gradients
  /// by the input for the rows of the last forward(); meaningless unless `by_input` is true.
  Rows<const T> backward_and_take(const AdamStep& step, bool by_input);

  /// Runs the forward pass for the derivative of a gradient by the input, as a gradient penalty
  /// needs it. Propagates the rows [first, first + rows) of input() through the layers without
  /// their biases, and only through units with a positive output in the last forward(). The results
  /// replace the layer inputs that forward() stored.
  void forward_derivative(std::int64_t first, std::int64_t rows);

  /// Number of first rows over which the gradients of weights and of biases are summed.
  struct Summed {
    std::int64_t of_weights;
    std::int64_t of_biases;
  };
  /// Returns the squared Euclidean norm of the gradients of all weights and biases together.
  [[nodiscard]] double squared_norm(const Summed& rows) const;
  [[nodiscard]] double squared_norm() const override { return squared_norm(batch()); }
  /// Takes one step of Adam with the gradients times `scale`.
  void take(const AdamStep& step, double scale, const Summed& rows);
  void take(const AdamStep& step, double scale) override { take(step, scale, batch()); }

 private:
  using Numbers = Eigen::ArrayX<T>;  // starts at the boundary of a vector register
  struct Layer {
    LayerSize size;
    std::int64_t weight;  ///< start of the weight in the array of all parameters
    std::int64_t bias;    ///< start of the bias in the same array
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
  /// Returns the rows of the first signal.
  [[nodiscard]] Summed batch() const { return {.of_weights = rows_, .of_biases = rows_}; }
  [[nodiscard]] TrainedWeight<T> trained(std::int64_t begin);
  void require_room_for(std::int64_t rows) const;
  /// Converts gradients by the input of layer i, which are stored in the layer before, to gradients
  /// by that layer's output before its ReLU.
  void pass_relu_back(std::size_t i, std::int64_t rows, std::int64_t signals);
  void take_bias(const Layer& layer, const AdamStep& step, double scale, std::int64_t rows);
  [[nodiscard]] std::vector<T> bias_gradient(const Layer& layer, std::int64_t rows) const;

  std::shared_ptr<Parameters<T>> parameters_;
  std::int64_t most_rows_;
  std::int64_t rows_ = 0;  ///< rows of the last forward()
  std::vector<Layer> layers_;
  Numbers output_;          ///< output of the last layer, [most_rows, held outputs]
  Numbers input_gradient_;  ///< input gradient of the first layer, [most_rows, held inputs]
  std::vector<T> no_bias_;  ///< zeros, instead of a bias
};

extern template class DenseChain<float>;
extern template class DenseChain<double>;

}  // namespace piae::nets

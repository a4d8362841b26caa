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
/// step waits for memory. The gradient of a weight is therefore never stored: it is a sum of as
/// many outer products as the batch has rows, and it is formed where it is used
/// (dense_kernels.hpp).
template <class T>
class DenseChain final : public Network<T> {
 public:
  /// A chain over the parameters <name>/0/weight, <name>/0/bias, <name>/1/weight, ..., for batches
  /// of up to `most_rows` rows. Several chains may share one set of parameters. Throws
  /// std::logic_error when no parameter has such a name; later calls throw it for more rows.
  DenseChain(std::shared_ptr<Parameters<T>> parameters, const std::string& name,
             std::int64_t most_rows);

  Rows<T> input() override {
    return rows_of(layers_.front().input, layers_.front().size.held_inputs);
  }
  Rows<const T> forward(std::int64_t rows) override;
  Rows<T> output_gradient() override { return output_gradient_of(layers_.back()); }
  Rows<const T> backward(std::int64_t rows, std::int64_t signals, RowRange by_input) override;

  /// backward() for one signal and then take() with a scale of 1, where no norm of all gradients is
  /// needed in between, in one pass over the weights. The gradients by the input are those for the
  /// rows of the last forward(), if they are wanted.
  Rows<const T> backward_and_take(const AdamStep& step, bool by_input);

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
  [[nodiscard]] double squared_norm() const override { return squared_norm(batch()); }
  /// One step of Adam by the gradients times `scale`.
  void take(const AdamStep& step, double scale, const Summed& rows);
  void take(const AdamStep& step, double scale) override { take(step, scale, batch()); }

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
  /// The rows of the first signal.
  [[nodiscard]] Summed batch() const { return {.of_weights = rows_, .of_biases = rows_}; }
  [[nodiscard]] TrainedWeight<T> trained(std::int64_t begin);
  void require_room_for(std::int64_t rows) const;
  /// From the gradients by the input of layer i, which stand in the layer before, to those by what
  /// that layer gave before its ReLU.
  void pass_relu_back(std::size_t i, std::int64_t rows, std::int64_t signals);
  void take_bias(const Layer& layer, const AdamStep& step, double scale, std::int64_t rows);
  [[nodiscard]] std::vector<T> bias_gradient(const Layer& layer, std::int64_t rows) const;

  std::shared_ptr<Parameters<T>> parameters_;
  std::int64_t most_rows_;
  std::int64_t rows_ = 0;  ///< of the last forward()
  std::vector<Layer> layers_;
  Numbers output_;          ///< [most_rows, held outputs] of the last layer
  Numbers input_gradient_;  ///< [most_rows, held inputs] of the first layer
  std::vector<T> no_bias_;  ///< zeros, in the place of a bias
};

extern template class DenseChain<float>;
extern template class DenseChain<double>;

}  // namespace piae::nets

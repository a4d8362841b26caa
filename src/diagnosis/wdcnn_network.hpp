#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/label.hpp"
#include "base/random.hpp"
#include "diagnosis/batch_normalisation.hpp"
#include "diagnosis/cross_entropy.hpp"
#include "diagnosis/time_convolution.hpp"
#include "diagnosis/wdcnn_layout.hpp"
#include "diagnosis/wdcnn_weights.hpp"

namespace piae::diagnosis {

/// WDCNN (layers in wdcnn_layers.hpp) with its gradients, for one core. It computes matrix products
/// and goes over memory that is allocated once. Programs use T = float; tests check it in double.
template <class T>
class WdcnnNetwork {
 public:
  /// For batches of at most `most_windows` windows of `length` samples, which must be at least
  /// WdcnnLayers::shortest_window. Initial values come from the stream, as wdcnn_parameters() says.
  WdcnnNetwork(std::int64_t length, std::int64_t classes, std::int64_t most_windows,
               const Stream& stream);

  /// In training, batch normalisation uses the statistics of the batch and updates the running
  /// ones. In evaluation, it uses the running ones.
  enum class Mode { training, evaluation };

  /// The logits of a batch; each of `windows` points to `length` samples. The logits of window i
  /// begin at i * logits_row(); the first `classes` numbers of a row count.
  const T* forward(std::span<const float* const> windows, Mode mode);
  [[nodiscard]] std::int64_t logits_row() const { return classes_.convolution.outputs; }

  /// The dense layer after ReLU, in the last forward(). That of window i begins at i *
  /// hidden_row(); the first WdcnnLayers::hidden numbers of a row count.
  [[nodiscard]] const T* hidden() const { return classes_.input.data(); }
  [[nodiscard]] std::int64_t hidden_row() const { return classes_.convolution.inputs; }

  /// Computes the gradients of the mean cross-entropy over the batch of the last forward(), which
  /// must have been in training mode, for these labels of its windows.
  BatchOutcome backward(std::span<const Label> labels);

  /// All parameters in one array, and their gradients (wdcnn_layout.hpp).
  [[nodiscard]] std::span<T> values() {
    return {values_.data(), static_cast<std::size_t>(values_.size())};
  }
  [[nodiscard]] std::span<const T> gradients() const { return span_of(gradients_); }
  [[nodiscard]] const std::vector<WdcnnParameter>& layout() const { return layout_; }

  /// The running statistics of the batch normalisation of layer i: 0 to 4 are the convolutions, 5
  /// is the dense layer.
  [[nodiscard]] std::span<const T> running_mean(std::size_t i) const {
    return span_of(layers_.at(i).running_mean);
  }
  [[nodiscard]] std::span<const T> running_variance(std::size_t i) const {
    return span_of(layers_.at(i).running_variance);
  }

  /// All that it has learned, rounded to single precision.
  [[nodiscard]] WdcnnWeights weights() const;
  /// Sets what weights() gives, of a network of the same length and classes.
  void set(const WdcnnWeights& weights);

 private:
  using Numbers = Eigen::ArrayX<T>;  // begins at the boundary of a vector register
  static std::span<const T> span_of(const Numbers& numbers) {
    return {numbers.data(), static_cast<std::size_t>(numbers.size())};
  }

  struct Layer {
    TimeConvolution convolution;
    std::int64_t weight;  ///< where it begins in the array of all parameters
    Numbers input;        ///< [input_length, windows, inputs]
    Numbers output;       ///< [output_length, windows, outputs]
  };
  struct NormalisedLayer : Layer {
    std::int64_t pooling;
    std::int64_t scale;         ///< where it begins in the array of all parameters
    std::int64_t shift;         ///< where it begins there
    Numbers mean;               ///< the statistic in use (Normalisation)
    Numbers inverse_deviation;  ///< the statistic in use (Normalisation)
    Numbers running_mean;
    Numbers running_variance;
  };

  [[nodiscard]] Layer make_layer(const TimeConvolution& convolution, const std::string& name) const;
  void make_layers();
  void make_scratch();
  [[nodiscard]] std::int64_t begin_of(const std::string& parameter) const;
  /// Where the output of layer i goes after it is normalised and pooled: the input of the next
  /// layer.
  [[nodiscard]] T* input_after(std::size_t i);
  [[nodiscard]] PooledShape pooled_shape(const NormalisedLayer& layer) const;
  [[nodiscard]] Normalisation<T> normalisation(NormalisedLayer& layer) const;
  void read(std::span<const float* const> windows);
  void propagate_to_weight(const Layer& layer);
  void propagate_to_input(const Layer& layer);

  std::int64_t length_;
  std::int64_t number_of_classes_;
  std::int64_t most_windows_;
  std::vector<WdcnnParameter> layout_;
  Numbers values_;
  Numbers gradients_;
  std::vector<NormalisedLayer> layers_;  ///< the convolutions and the dense layer
  Layer classes_;
  std::int64_t bias_;         ///< where the bias of the classes begins in the array of parameters
  std::int64_t windows_ = 0;  ///< in the batch
  // Scratch memory, large enough for every layer:
  Numbers output_gradient_;  ///< the gradient by the output of a convolution
  Numbers pooled_gradient_;  ///< the gradient by what that becomes, the input of the next layer
  Numbers transposed_;       ///< the transposed weight
};

extern template class WdcnnNetwork<float>;
extern template class WdcnnNetwork<double>;

}  // namespace piae::diagnosis

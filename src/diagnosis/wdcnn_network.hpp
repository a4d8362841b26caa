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
/// on memory that is allocated once. Programs use T = float; tests check it in double.
template <class T>
class WdcnnNetwork {
 public:
  /// Makes a network for batches of at most `most_windows` windows of `length` samples, which must
  /// be at least WdcnnLayers::shortest_window. Initial values come from the stream, as in
  /// wdcnn_parameters().
  WdcnnNetwork(std::int64_t length, std::int64_t classes, std::int64_t most_windows,
               const Stream& stream);

  /// Batch normalisation uses the batch's statistics in training, and updates the running ones; in
  /// evaluation it uses the running ones.
  enum class Mode { training, evaluation };

  /// Returns the logits of a batch; each of `windows` points to `length` samples. The logits of
  /// window i begin at i * logits_row(); the first `classes` numbers of a row count.
  const T* forward(std::span<const float* const> windows, Mode mode);
  [[nodiscard]] std::int64_t logits_row() const { return classes_.convolution.outputs; }

  [[nodiscard]] const T* logits() const { return classes_.output.data(); }

  /// Returns the dense layer after ReLU of the last forward(). The values of window i begin at i *
  /// hidden_row(); the first WdcnnLayers::hidden numbers of a row count.
  [[nodiscard]] const T* hidden() const { return classes_.input.data(); }
  [[nodiscard]] std::int64_t hidden_row() const { return classes_.convolution.inputs; }

  /// Computes the gradients of the mean cross-entropy for the labels of the first windows of the
  /// last batch; the other windows have no label. `by_hidden` is a gradient of another loss with
  /// respect to hidden(), in its layout; empty if there is none. The last forward() must have been
  /// in training mode.
  BatchOutcome backward(std::span<const Label> labels, std::span<const T> by_hidden = {});

  /// Return all parameters in one array, and their gradients (wdcnn_layout.hpp).
  [[nodiscard]] std::span<T> values() {
    return {values_.data(), static_cast<std::size_t>(values_.size())};
  }
  [[nodiscard]] std::span<const T> gradients() const { return span_of(gradients_); }
  [[nodiscard]] const std::vector<WdcnnParameter>& layout() const { return layout_; }

  /// Return the running statistics of the batch normalisation of layer i: 0 to 4 are the
  /// convolutions, 5 is the dense layer.
  [[nodiscard]] std::span<const T> running_mean(std::size_t i) const {
    return span_of(layers_.at(i).running_mean);
  }
  [[nodiscard]] std::span<const T> running_variance(std::size_t i) const {
    return span_of(layers_.at(i).running_variance);
  }

  /// Returns all learned numbers, rounded to single precision.
  [[nodiscard]] WdcnnWeights weights() const;
  /// Sets the weights of a network of the same length and classes.
  void set(const WdcnnWeights& weights);

 private:
  using Numbers = Eigen::ArrayX<T>;  // aligned to a vector register
  static std::span<const T> span_of(const Numbers& numbers) {
    return {numbers.data(), static_cast<std::size_t>(numbers.size())};
  }

  struct Layer {
    TimeConvolution convolution;
    std::int64_t weight;  ///< its index in the array of all parameters
    Numbers input;        ///< [input_length, windows, inputs]
    Numbers output;       ///< [output_length, windows, outputs]
  };
  struct NormalisedLayer : Layer {
    std::int64_t pooling;
    std::int64_t scale;         ///< its index in the array of all parameters
    std::int64_t shift;         ///< its index there
    Numbers mean;               ///< the statistic in use (Normalisation)
    Numbers inverse_deviation;  ///< the statistic in use (Normalisation)
    Numbers running_mean;
    Numbers running_variance;
  };

  [[nodiscard]] Layer make_layer(const TimeConvolution& convolution, const std::string& name) const;
  void make_layers();
  void make_scratch();
  [[nodiscard]] std::int64_t begin_of(const std::string& parameter) const;
  /// Returns where the normalised and pooled output of layer i goes: the input of the next layer.
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
  std::int64_t bias_;         ///< index of the classes' bias in the array of parameters
  std::int64_t windows_ = 0;  ///< in the batch
  // Scratch memory, large enough for every layer:
  Numbers output_gradient_;  ///< gradient with respect to a convolution's output
  Numbers pooled_gradient_;  ///< gradient with respect to the next layer's input
  Numbers transposed_;       ///< transposed weight
};

extern template class WdcnnNetwork<float>;
extern template class WdcnnNetwork<double>;

}  // namespace piae::diagnosis

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "diagnosis/batch_normalisation.hpp"
#include "diagnosis/cross_entropy.hpp"
#include "diagnosis/wdcnn_layout.hpp"
#include "diagnosis/time_convolution.hpp"

namespace piae::diagnosis {

/// WDCNN for one core: the mathematics of WdcnnNetwork (wdcnn_network.hpp) in matrix products and
/// passes over memory that is allocated once. T is float; double serves to check it.
template <class T>
class WdcnnNetwork {
 public:
  /// For batches of at most `most_windows` windows of `length` samples, at least
  /// WdcnnLayers::shortest_window. Starts with the values that WdcnnNetwork starts with.
  WdcnnNetwork(std::int64_t length, std::int64_t classes, std::int64_t most_windows,
                const Stream& stream);

  /// As in WdcnnNetwork.
  enum class Mode { training, evaluation };

  /// Logits of a batch; each of `windows` points to `length` samples. Row i, of which the first
  /// `classes` numbers count, begins at i * logits_row().
  const T* forward(std::span<const float* const> windows, Mode mode);
  [[nodiscard]] std::int64_t logits_row() const { return classes_.convolution.outputs; }

  /// Gradients of the mean cross-entropy over the batch of the last forward pass, which must have
  /// been in training mode.
  BatchOutcome backward(std::span<const std::int32_t> labels);

  /// All parameters in one flat vector, and their gradients (wdcnn_layout.hpp).
  [[nodiscard]] std::span<T> values() {
    return {values_.data(), static_cast<std::size_t>(values_.size())};
  }
  [[nodiscard]] std::span<const T> gradients() const { return span_of(gradients_); }
  [[nodiscard]] const std::vector<WdcnnParameter>& layout() const { return layout_; }

  /// Running statistics of batch normalisation i: 0-4 of the convolutions, 5 of the dense layer.
  [[nodiscard]] std::span<const T> running_mean(std::size_t i) const {
    return span_of(layers_.at(i).running_mean);
  }
  [[nodiscard]] std::span<const T> running_variance(std::size_t i) const {
    return span_of(layers_.at(i).running_variance);
  }

 private:
  /// On the boundary of vectors.
  using Numbers = Eigen::ArrayX<T>;
  static std::span<const T> span_of(const Numbers& numbers) {
    return {numbers.data(), static_cast<std::size_t>(numbers.size())};
  }

  struct Layer {
    TimeConvolution convolution;
    std::int64_t weight;  ///< where it begins in the flat vector
    Numbers input;        ///< [input_length, windows, inputs]
    Numbers output;       ///< [output_length, windows, outputs]
  };
  struct NormalisedLayer : Layer {
    std::int64_t pooling;
    std::int64_t scale;  ///< where it begins in the flat vector
    std::int64_t shift;
    Numbers mean;  ///< this and the next: of the last batch
    Numbers inverse_deviation;
    Numbers running_mean;
    Numbers running_variance;
  };

  [[nodiscard]] Layer make_layer(const TimeConvolution& convolution, const std::string& name) const;
  void make_layers();
  void make_scratch();
  [[nodiscard]] std::int64_t begin_of(const std::string& parameter) const;
  /// Where the output of layer i, once normalised and pooled, goes.
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
  std::int64_t bias_;         ///< where that of the classes begins in the flat vector
  std::int64_t windows_ = 0;  ///< in the batch
  // Scratch, large enough for every layer:
  Numbers output_gradient_;  ///< by the output of a convolution
  Numbers pooled_gradient_;  ///< by what it becomes, the input of the next
  Numbers transposed_;       ///< its weight
};

extern template class WdcnnNetwork<float>;
extern template class WdcnnNetwork<double>;

}  // namespace piae::diagnosis

#pragma once

#include <torch/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/random.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "libtorch/nets/parameters.hpp"

namespace piae::libtorch {

/// WDCNN by LibTorch's operations. diagnosis::wdcnn_parameters() defines the names, shapes and
/// initial values of its parameters.
class WdcnnNetwork {
 public:
  /// `length` is the number of samples of a window, at least
  /// diagnosis::WdcnnLayers::shortest_window.
  WdcnnNetwork(std::int64_t length, std::int64_t classes, const Stream& stream,
               torch::Dtype dtype = torch::kFloat32, torch::Device device = torch::kCPU);

  /// When training, batch normalisation uses the statistics of the batch and updates the running
  /// ones. When evaluating, it uses the running ones.
  enum class Mode { training, evaluation };

  /// Returns the logits [n, classes] of windows [n, length].
  torch::Tensor forward(const torch::Tensor& windows, Mode mode) {
    return classify(hidden(windows, mode));
  }
  /// Returns the dense layer after ReLU, [n, diagnosis::WdcnnLayers::hidden], of windows [n,
  /// length].
  torch::Tensor hidden(const torch::Tensor& windows, Mode mode);
  /// Returns the logits for an output of hidden().
  [[nodiscard]] torch::Tensor classify(const torch::Tensor& hidden) const;

  /// Runs convolution i with its normalisation, pooling and ReLU: [n, inputs, length] -> [n,
  /// outputs, a shorter length].
  torch::Tensor convolve(std::size_t i, const torch::Tensor& input, Mode mode);

  /// Running statistics of the batch normalisation of layer i: 0 to 4 are the convolutions, 5 is
  /// the dense layer.
  struct RunningStatistics {
    torch::Tensor mean;      ///< [channels], starts at 0
    torch::Tensor variance;  ///< [channels], starts at 1
  };
  [[nodiscard]] const RunningStatistics& running(std::size_t i) const {
    return layers_.at(i).running;
  }

  ParameterSet& parameters() { return parameters_; }
  [[nodiscard]] const ParameterSet& parameters() const { return parameters_; }
  [[nodiscard]] std::int64_t classes() const { return classes_bias_.size(0); }

 private:
  struct Layer {
    torch::Tensor weight;
    torch::Tensor scale;
    torch::Tensor shift;
    RunningStatistics running;
  };
  static torch::Tensor normalise(const Layer& layer, const torch::Tensor& input, Mode mode);

  ParameterSet parameters_;
  std::vector<Layer> layers_;  ///< the convolutions and the dense layer
  torch::Tensor classes_weight_;
  torch::Tensor classes_bias_;
};

}  // namespace piae::libtorch

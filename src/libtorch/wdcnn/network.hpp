#pragma once

#include <torch/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/random.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "libtorch/nets/parameters.hpp"

namespace piae::libtorch {

/// WDCNN as LibTorch tensors. Parameters are called, shaped and started as diagnosis::wdcnn_parameters() says.
class WdcnnNetwork {
 public:
  /// For windows of `length` samples, at least diagnosis::WdcnnLayers::shortest_window.
  WdcnnNetwork(std::int64_t length, std::int64_t classes, const Stream& stream,
               torch::Dtype dtype = torch::kFloat32, torch::Device device = torch::kCPU);

  /// Statistics of the batch are used, and enter the running ones, while training; the running ones
  /// otherwise.
  enum class Mode { training, evaluation };

  /// Logits [n, classes] of windows [n, length].
  torch::Tensor forward(const torch::Tensor& windows, Mode mode);

  /// Convolution i with all that follows it: [n, inputs, length] to [n, outputs, shorter].
  torch::Tensor convolve(std::size_t i, const torch::Tensor& input, Mode mode);

  /// Running statistics of batch normalisation i: 0-4 of the convolutions, 5 of the dense layer.
  struct RunningStatistics {
    torch::Tensor mean;      ///< [channels], starts at 0
    torch::Tensor variance;  ///< [channels], starts at 1
  };
  [[nodiscard]] const RunningStatistics& running(std::size_t i) const {
    return layers_.at(i).running;
  }

  ParameterSet& parameters() { return parameters_; }

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

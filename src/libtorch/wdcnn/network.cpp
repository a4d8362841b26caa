#include "libtorch/wdcnn/network.hpp"

#include <string>
#include <tuple>

#include "diagnosis/wdcnn_parameters.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

namespace {

constexpr std::size_t convolutions = diagnosis::WdcnnLayers::convolutions.size();

/// Max-pooling of [n, channels, length]. A maximum over an axis of two costs LibTorch a third less
/// than its max_pool1d, and gives the same bits.
torch::Tensor pool(torch::Tensor x) {
  const std::int64_t pooled = x.size(2) / diagnosis::WdcnnLayers::pooling;
  if (x.size(2) % diagnosis::WdcnnLayers::pooling != 0) x = x.narrow(2, 0, pooled * diagnosis::WdcnnLayers::pooling);
  return std::get<0>(x.unflatten(2, {pooled, diagnosis::WdcnnLayers::pooling}).max(3));
}

}  // namespace

WdcnnNetwork::WdcnnNetwork(std::int64_t length, std::int64_t classes, const Stream& stream,
                           torch::Dtype dtype, torch::Device device)
    : parameters_(diagnosis::wdcnn_parameters(length, classes), stream, dtype, device) {
  for (std::size_t i = 0; i <= convolutions; ++i) {
    const std::string name = diagnosis::layer_name(i);
    const torch::Tensor& shift = parameters_[name + "/shift"];
    layers_.push_back({parameters_[name + "/weight"],
                       parameters_[name + "/scale"],
                       shift,
                       {torch::zeros_like(shift), torch::ones_like(shift)}});
  }
  classes_weight_ = parameters_["classes/weight"];
  classes_bias_ = parameters_["classes/bias"];
}

torch::Tensor WdcnnNetwork::normalise(const Layer& layer, const torch::Tensor& input, Mode mode) {
  return torch::batch_norm(input, layer.scale, layer.shift, layer.running.mean,
                           layer.running.variance, mode == Mode::training,
                           diagnosis::BatchNormalisation::momentum, diagnosis::BatchNormalisation::epsilon,
                           /*cudnn_enabled=*/true);
}

torch::Tensor WdcnnNetwork::convolve(std::size_t i, const torch::Tensor& input, Mode mode) {
  const diagnosis::Convolution& c = diagnosis::WdcnnLayers::convolutions.at(i);
  const Layer& layer = layers_[i];
  const torch::Tensor filtered =
      torch::conv1d(input, layer.weight, torch::Tensor(), c.stride, c.padding);
  // ReLU after pooling is the same as before it, on half as many values.
  return pool(normalise(layer, filtered, mode)).relu_();
}

torch::Tensor WdcnnNetwork::forward(const torch::Tensor& windows, Mode mode) {
  torch::Tensor x = windows.unsqueeze(1);
  for (std::size_t i = 0; i < convolutions; ++i) x = convolve(i, x, mode);
  const Layer& dense = layers_[convolutions];
  x = normalise(dense, torch::linear(x.flatten(1), dense.weight), mode).relu_();
  return torch::linear(x, classes_weight_, classes_bias_);
}

}  // namespace piae::libtorch

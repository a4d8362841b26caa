#include "libtorch/wdcnn/network.hpp"

#include <string>
#include <tuple>

#include "diagnosis/wdcnn_weights.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

namespace {

using diagnosis::BatchNormalisation;
using diagnosis::WdcnnLayers;

constexpr std::size_t convolutions = WdcnnLayers::convolutions.size();

/// Max-pools [n, channels, length]. A maximum over an axis of two takes two thirds of the time of
/// LibTorch's max_pool1d and gives the same bits.
torch::Tensor pool(torch::Tensor x) {
  const std::int64_t pooled = x.size(2) / WdcnnLayers::pooling;
  if (x.size(2) % WdcnnLayers::pooling != 0) x = x.narrow(2, 0, pooled * WdcnnLayers::pooling);
  return std::get<0>(x.unflatten(2, {pooled, WdcnnLayers::pooling}).max(3));
}

}  // namespace

WdcnnNetwork::WdcnnNetwork(std::int64_t length, std::int64_t classes, const Stream& stream,
                           torch::Dtype dtype, torch::Device device)
    : parameters_(diagnosis::wdcnn_parameters(length, classes), stream, dtype, device) {
  for (std::size_t i = 0; i <= convolutions; ++i) {
    const std::string name = diagnosis::layer_name(i);
    const torch::Tensor& shift = parameters_[name + "/shift"];
    layers_.push_back(
        {.weight = parameters_[name + "/weight"],
         .scale = parameters_[name + "/scale"],
         .shift = shift,
         .running = {.mean = torch::zeros_like(shift), .variance = torch::ones_like(shift)}});
  }
  classes_weight_ = parameters_["classes/weight"];
  classes_bias_ = parameters_["classes/bias"];
}

torch::Tensor WdcnnNetwork::normalise(const Layer& layer, const torch::Tensor& input, Mode mode) {
  return torch::batch_norm(input, layer.scale, layer.shift, layer.running.mean,
                           layer.running.variance, mode == Mode::training,
                           BatchNormalisation::momentum, BatchNormalisation::epsilon,
                           /*cudnn_enabled=*/true);
}

torch::Tensor WdcnnNetwork::convolve(std::size_t i, const torch::Tensor& input, Mode mode) {
  const diagnosis::Convolution& c = WdcnnLayers::convolutions.at(i);
  const Layer& layer = layers_[i];
  const torch::Tensor filtered =
      torch::conv1d(input, layer.weight, torch::Tensor(), c.stride, c.padding);
  // ReLU after pooling gives the same result as before it, on half as many values.
  return pool(normalise(layer, filtered, mode)).relu_();
}

torch::Tensor WdcnnNetwork::hidden(const torch::Tensor& windows, Mode mode) {
  torch::Tensor x = windows.unsqueeze(1);
  for (std::size_t i = 0; i < convolutions; ++i) x = convolve(i, x, mode);
  const Layer& dense = layers_[convolutions];
  return normalise(dense, torch::linear(x.flatten(1), dense.weight), mode).relu_();
}

torch::Tensor WdcnnNetwork::classify(const torch::Tensor& hidden) const {
  return torch::linear(hidden, classes_weight_, classes_bias_);
}

}  // namespace piae::libtorch

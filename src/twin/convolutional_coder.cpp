#include "twin/convolutional_coder.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "base/error.hpp"
#include "nets/position_dense.hpp"
#include "nets/relu.hpp"
#include "nets/strided_convolution.hpp"
#include "nets/transposition.hpp"

namespace piae::twin {

namespace {

using Specs = std::vector<nets::ParameterSpec>;

/// Returns the parameters of a layer with `inputs_of_one` inputs per output.
Specs layer_specs(const std::string& name, const std::vector<std::int64_t>& shape,
                  std::int64_t outputs, std::int64_t inputs_of_one) {
  const double bound = 1 / std::sqrt(static_cast<double>(inputs_of_one));
  return {{name + "/weight", shape, bound}, {name + "/bias", {outputs}, bound}};
}

/// Returns the name of a convolution within its network.
std::string own_name(std::int64_t i) { return "conv" + std::to_string(i); }

}  // namespace

std::string convolution_name(const std::string& network, std::int64_t i) {
  return network + "/" + own_name(i);
}
std::string dense_name(const std::string& network) { return network + "/dense"; }

ConvolutionalCoder::ConvolutionalCoder(const NetworkShape& shape, const TwinOptions& options)
    : shape_(shape), convolutions_(layers_except_dense(options.depth, "convolution")) {
  std::int64_t step = 1;
  for (std::int64_t i = 0; i < convolutions_; ++i) step *= stride;
  if (shape.samples % step != 0) {
    throw Error(Exit::usage,
                fmt::format("windows of {} samples do not fit {} convolutions of stride {}; use "
                            "multiples of {} samples (split --window) or a smaller --depth",
                            shape.samples, convolutions_, stride, step));
  }
  inner_length_ = shape.samples / step;
}

std::vector<nets::ParameterSpec> ConvolutionalCoder::specs() const {
  Specs specs;
  for (std::int64_t i = 0; i < convolutions_; ++i) {
    const std::int64_t inputs = channels_after(i);
    const std::int64_t outputs = channels_after(i + 1);
    append(specs, layer_specs(convolution_name(encoder_name, i), {outputs, inputs, kernel}, outputs,
                              inputs * kernel));
  }
  const std::int64_t features = inner_channels() * inner_length_;
  append(specs, nets::dense_specs(dense_name(encoder_name), features, 2));
  append(specs, nets::dense_specs(dense_name(decoder_name), 2 + shape_.classes, features));
  for (std::int64_t i = 0; i < convolutions_; ++i) {
    const std::int64_t inputs = channels_after(convolutions_ - i);
    const std::int64_t outputs = channels_after(convolutions_ - i - 1);
    // The kernels of neighbouring inputs are `stride` apart, so kernel / stride of them reach each
    // sample.
    append(specs, layer_specs(convolution_name(decoder_name, i), {inputs, outputs, kernel}, outputs,
                              inputs * kernel / stride));
  }
  return specs;
}

template <class T>
Layers<T> ConvolutionalCoder::encoder_layers(nets::GradientArray<T>& parameters) const {
  Layers<T> layers;
  std::int64_t length = shape_.samples;
  for (std::int64_t i = 0; i < convolutions_; ++i, length /= stride) {
    layers.push_back(std::make_unique<nets::StridedConvolution<T>>(
        parameters, own_name(i), nets::ConvolutionKind::strided, length));
    layers.push_back(std::make_unique<nets::Relu<T>>(layers.back()->output()));
  }
  layers.push_back(std::make_unique<nets::Transposition<T>>(layers.back()->output()));
  layers.push_back(std::make_unique<nets::PositionDense<T>>(parameters, "dense", 1));
  return layers;
}

template <class T>
Layers<T> ConvolutionalCoder::decoder_layers(nets::GradientArray<T>& parameters) const {
  auto layers = nets::layers<T>(std::make_unique<nets::PositionDense<T>>(parameters, "dense", 1),
                                std::make_unique<nets::Transposition<T>>(nets::SequenceShape{
                                    .length = inner_channels(), .width = inner_length_}));
  std::int64_t length = inner_length_;
  for (std::int64_t i = 0; i < convolutions_; ++i, length *= stride) {
    layers.push_back(std::make_unique<nets::Relu<T>>(layers.back()->output()));
    layers.push_back(std::make_unique<nets::StridedConvolution<T>>(
        parameters, own_name(i), nets::ConvolutionKind::transposed, length));
  }
  return layers;
}

PIAE_INSTANTIATE_SEQUENCE_CODER(ConvolutionalCoder);

}  // namespace piae::twin

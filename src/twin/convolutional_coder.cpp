#include "twin/convolutional_coder.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "base/error.hpp"
#include "nets/convolutional_chain.hpp"
#include "nets/dense_chain.hpp"
#include "nets/joined_networks.hpp"
#include "twin/specs.hpp"

namespace piae::twin {

namespace {

using Specs = std::vector<nets::ParameterSpec>;
using Convolutions = nets::ConvolutionalChain<float>;
using Dense = nets::DenseChain<float>;
using Joined = nets::JoinedNetworks<float>;

/// The parameters of a layer each of whose outputs is computed from `inputs_of_one` inputs.
Specs layer_specs(const std::string& name, const std::vector<std::int64_t>& shape,
                  std::int64_t outputs, std::int64_t inputs_of_one) {
  const double bound = 1 / std::sqrt(static_cast<double>(inputs_of_one));
  return {{name + "/weight", shape, bound}, {name + "/bias", {outputs}, bound}};
}

}  // namespace

std::string convolution_name(const std::string& network, std::int64_t i) {
  return network + "/conv" + std::to_string(i);
}
std::string dense_name(const std::string& network) { return network + "/dense"; }

ConvolutionalCoder::ConvolutionalCoder(const NetworkShape& shape, const TwinOptions& options)
    : shape_(shape), convolutions_(options.depth - 1) {
  if (convolutions_ < 1) {
    throw Error(Exit::usage,
                "--depth: 1 leaves no convolution, since the layer at (k, c) is dense; 2 or more "
                "layers work");
  }
  std::int64_t step = 1;
  for (std::int64_t i = 0; i < convolutions_; ++i) step *= stride;
  if (shape.samples % step != 0) {
    throw Error(Exit::usage,
                fmt::format("windows of {} samples do not go through {} convolutions of stride {}; "
                            "multiples of {} samples do (split --window), or a smaller --depth",
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
    // The kernels of neighbouring inputs lie `stride` apart, so kernel / stride of them reach each
    // sample.
    append(specs, layer_specs(convolution_name(decoder_name, i), {inputs, outputs, kernel}, outputs,
                              inputs * kernel / stride));
  }
  return specs;
}

std::unique_ptr<Coder::Network> ConvolutionalCoder::encoder(
    const std::shared_ptr<Parameters>& parameters, std::int64_t most_rows) const {
  return std::make_unique<Joined>(
      std::make_unique<Convolutions>(parameters, encoder_name, nets::ConvolutionKind::strided,
                                     shape_.samples, most_rows),
      inner_length_, inner_channels(),
      std::make_unique<Dense>(parameters, dense_name(encoder_name), most_rows));
}

std::unique_ptr<Coder::Network> ConvolutionalCoder::decoder(
    const std::shared_ptr<Parameters>& parameters, std::int64_t most_rows) const {
  return std::make_unique<Joined>(
      std::make_unique<Dense>(parameters, dense_name(decoder_name), most_rows), inner_channels(),
      inner_length_,
      std::make_unique<Convolutions>(parameters, decoder_name, nets::ConvolutionKind::transposed,
                                     inner_length_, most_rows));
}

}  // namespace piae::twin

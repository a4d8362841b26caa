#include "libtorch/twin/convolutional_coder.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "base/error.hpp"
#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/torch.hpp"
#include "twin/specs.hpp"

namespace piae::libtorch {

namespace {

const std::string encoder_dense = twin::encoder_name + "/dense";
const std::string decoder_dense = twin::decoder_name + "/dense";

std::string encoder_layer(std::int64_t i) {
  return twin::encoder_name + "/conv" + std::to_string(i);
}
std::string decoder_layer(std::int64_t i) {
  return twin::decoder_name + "/conv" + std::to_string(i);
}

using Specs = std::vector<nets::ParameterSpec>;

/// The parameters of a layer each of whose outputs is computed from `inputs_of_one` inputs.
Specs layer_specs(const std::string& name, const std::vector<std::int64_t>& shape,
                  std::int64_t outputs, std::int64_t inputs_of_one) {
  const double bound = 1 / std::sqrt(static_cast<double>(inputs_of_one));
  return {{name + "/weight", shape, bound}, {name + "/bias", {outputs}, bound}};
}

}  // namespace

ConvolutionalCoder::ConvolutionalCoder(const twin::NetworkShape& shape,
                                       const twin::TwinOptions& options)
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
    append(specs,
           layer_specs(encoder_layer(i), {outputs, inputs, kernel}, outputs, inputs * kernel));
  }
  const std::int64_t features = channels_after(convolutions_) * inner_length_;
  append(specs, nets::dense_specs(encoder_dense, features, 2));
  append(specs, nets::dense_specs(decoder_dense, 2 + shape_.classes, features));
  for (std::int64_t i = 0; i < convolutions_; ++i) {
    const std::int64_t inputs = channels_after(convolutions_ - i);
    const std::int64_t outputs = channels_after(convolutions_ - i - 1);
    // The kernels of neighbouring inputs lie `stride` apart, so kernel / stride of them reach each
    // sample.
    append(specs, layer_specs(decoder_layer(i), {inputs, outputs, kernel}, outputs,
                              inputs * kernel / stride));
  }
  return specs;
}

torch::Tensor ConvolutionalCoder::encode(const ParameterSet& parameters,
                                         const torch::Tensor& windows) const {
  torch::Tensor x = windows.unsqueeze(1);
  for (std::int64_t i = 0; i < convolutions_; ++i) {
    const std::string name = encoder_layer(i);
    x = torch::relu(torch::conv1d(x, parameters[name + "/weight"], parameters[name + "/bias"],
                                  stride, padding));
  }
  return run_dense(parameters, encoder_dense, x.flatten(1));
}

torch::Tensor ConvolutionalCoder::decode(const ParameterSet& parameters,
                                         const torch::Tensor& input) const {
  torch::Tensor x = run_dense(parameters, decoder_dense, input)
                        .view({input.size(0), channels_after(convolutions_), inner_length_});
  for (std::int64_t i = 0; i < convolutions_; ++i) {
    const std::string name = decoder_layer(i);
    x = torch::conv_transpose1d(torch::relu(x), parameters[name + "/weight"],
                                parameters[name + "/bias"], stride, padding);
  }
  return x.squeeze(1);
}

}  // namespace piae::libtorch

#include "libtorch/twin/convolutional_coder.hpp"

#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/torch.hpp"
#include "twin/specs.hpp"

namespace piae::libtorch {

using Own = twin::ConvolutionalCoder;

torch::Tensor ConvolutionalCoder::encode(const ParameterSet& parameters,
                                         const torch::Tensor& windows) const {
  torch::Tensor x = windows.unsqueeze(1);
  for (std::int64_t i = 0; i < own_.convolutions(); ++i) {
    const std::string name = twin::convolution_name(twin::encoder_name, i);
    x = torch::relu(torch::conv1d(x, parameters[name + "/weight"], parameters[name + "/bias"],
                                  Own::stride, Own::padding));
  }
  return run_dense(parameters, twin::dense_name(twin::encoder_name), x.flatten(1));
}

torch::Tensor ConvolutionalCoder::decode(const ParameterSet& parameters,
                                         const torch::Tensor& input) const {
  torch::Tensor x = run_dense(parameters, twin::dense_name(twin::decoder_name), input)
                        .view({input.size(0), own_.inner_channels(), own_.inner_length()});
  for (std::int64_t i = 0; i < own_.convolutions(); ++i) {
    const std::string name = twin::convolution_name(twin::decoder_name, i);
    x = torch::conv_transpose1d(torch::relu(x), parameters[name + "/weight"],
                                parameters[name + "/bias"], Own::stride, Own::padding);
  }
  return x.squeeze(1);
}

}  // namespace piae::libtorch

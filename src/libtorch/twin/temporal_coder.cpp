#include "libtorch/twin/temporal_coder.hpp"

#include <spdlog/fmt/fmt.h>

#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/dilated.hpp"
#include "libtorch/nets/torch.hpp"
#include "twin/specs.hpp"

namespace piae::libtorch {

namespace {

using twin::decoder_name;
using twin::encoder_name;

}  // namespace

torch::Tensor TemporalCoder::run_blocks(const ParameterSet& parameters, const std::string& network,
                                        torch::Tensor x) const {
  for (std::int64_t i = 0; i < layers_.blocks(); ++i) {
    torch::Tensor branch = x;
    for (const char* const convolution : {"conv0", "conv1"}) {
      branch = torch::relu(
          run_dilated_convolution(parameters, fmt::format("{}/block{}/{}", network, i, convolution),
                                  branch, twin::TemporalCoder::dilation(i)));
    }
    x = torch::relu(x + branch);
  }
  return x;
}

torch::Tensor TemporalCoder::encode(const ParameterSet& parameters,
                                    const torch::Tensor& windows) const {
  const torch::Tensor frames = windows.view({windows.size(0), -1, twin::TemporalCoder::frame});
  const torch::Tensor x = run_dense(parameters, encoder_name + "/frames", frames).transpose(1, 2);
  return run_dense(parameters, encoder_name + "/dense",
                   run_blocks(parameters, encoder_name, x).mean(2));
}

torch::Tensor TemporalCoder::decode(const ParameterSet& parameters,
                                    const torch::Tensor& input) const {
  const torch::Tensor x = run_dense(parameters, decoder_name + "/dense", input)
                              .view({input.size(0), -1, twin::TemporalCoder::channels})
                              .transpose(1, 2);
  return run_dense(parameters, decoder_name + "/frames",
                   run_blocks(parameters, decoder_name, x).transpose(1, 2))
      .flatten(1);
}

}  // namespace piae::libtorch

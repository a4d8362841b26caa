#include "libtorch/twin/recurrent_coder.hpp"

#include <tuple>

#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/torch.hpp"
#include "twin/specs.hpp"

namespace piae::libtorch {

using twin::decoder_name;
using twin::encoder_name;

torch::Tensor RecurrentCoder::run_gru(const ParameterSet& parameters, const std::string& name,
                                      const torch::Tensor& x) const {
  const torch::Tensor at_rest =
      torch::zeros({sizes_.layers(), x.size(0), twin::RecurrentCoder::units}, x.options());
  return std::get<0>(torch::gru(x, at_rest, parameters.with_prefix(name + "/gru"),
                                /*has_biases=*/true, sizes_.layers(), /*dropout=*/0, /*train=*/true,
                                /*bidirectional=*/false, /*batch_first=*/true));
}

torch::Tensor RecurrentCoder::encode(const ParameterSet& parameters,
                                     const torch::Tensor& windows) const {
  const torch::Tensor frames = windows.view({windows.size(0), -1, twin::RecurrentCoder::frame});
  return run_dense(parameters, encoder_name + "/dense",
                   run_gru(parameters, encoder_name, frames).select(1, -1));
}

torch::Tensor RecurrentCoder::decode(const ParameterSet& parameters,
                                     const torch::Tensor& input) const {
  const torch::Tensor each_frame = input.unsqueeze(1).expand({-1, sizes_.frames(), -1});
  return run_dense(parameters, decoder_name + "/dense",
                   run_gru(parameters, decoder_name, each_frame))
      .flatten(1);
}

}  // namespace piae::libtorch

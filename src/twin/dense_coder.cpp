#include "twin/dense_coder.hpp"

#include "nets/dense.hpp"
#include "nets/torch.hpp"
#include "twin/specs.hpp"

namespace piae::twin {

std::vector<nets::ParameterSpec> DenseCoder::specs() const {
  return dense_coder_specs(shape_, options_);
}

torch::Tensor DenseCoder::encode(const nets::ParameterSet& parameters,
                                 const torch::Tensor& x) const {
  return nets::run_dense_chain(parameters, encoder_name, x);
}

torch::Tensor DenseCoder::decode(const nets::ParameterSet& parameters,
                                 const torch::Tensor& input) const {
  return nets::run_dense_chain(parameters, decoder_name, input);
}

}  // namespace piae::twin

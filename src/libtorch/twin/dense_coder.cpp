#include "libtorch/twin/dense_coder.hpp"

#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/torch.hpp"
#include "twin/dense_coder.hpp"
#include "twin/specs.hpp"

namespace piae::libtorch {

std::vector<nets::ParameterSpec> DenseCoder::specs() const {
  return twin::DenseCoder(shape_, options_).specs();
}

torch::Tensor DenseCoder::encode(const ParameterSet& parameters, const torch::Tensor& x) const {
  return run_dense_chain(parameters, twin::encoder_name, x);
}

torch::Tensor DenseCoder::decode(const ParameterSet& parameters, const torch::Tensor& input) const {
  return run_dense_chain(parameters, twin::decoder_name, input);
}

}  // namespace piae::libtorch

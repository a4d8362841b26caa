#include "twin/dense_coder.hpp"

#include "nets/dense.hpp"
#include "nets/torch.hpp"

namespace piae::twin {

namespace {

const std::string encoder = "net/encoder";
const std::string decoder = "net/decoder";

}  // namespace

std::vector<nets::ParameterSpec> DenseCoder::specs() const {
  const nets::DenseSize size{depth_, width_};
  auto specs = nets::dense_chain_specs(encoder, shape_.samples, 2, size);
  const auto rest = nets::dense_chain_specs(decoder, 2 + shape_.classes, shape_.samples, size);
  specs.insert(specs.end(), rest.begin(), rest.end());
  return specs;
}

torch::Tensor DenseCoder::encode(const nets::ParameterSet& parameters,
                                 const torch::Tensor& x) const {
  return nets::run_dense_chain(parameters, encoder, x);
}

torch::Tensor DenseCoder::decode(const nets::ParameterSet& parameters,
                                 const torch::Tensor& input) const {
  return nets::run_dense_chain(parameters, decoder, input);
}

}  // namespace piae::twin

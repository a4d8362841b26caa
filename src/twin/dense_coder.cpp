#include "twin/dense_coder.hpp"

#include "nets/dense_chain.hpp"
#include "twin/specs.hpp"

namespace piae::twin {

std::vector<nets::ParameterSpec> DenseCoder::specs() const {
  auto specs = nets::dense_chain_specs(encoder_name, shape_.samples, 2, size_);
  append(specs, nets::dense_chain_specs(decoder_name, 2 + shape_.classes, shape_.samples, size_));
  return specs;
}

std::unique_ptr<Coder::Network> DenseCoder::encoder(const std::shared_ptr<Parameters>& parameters,
                                                    std::int64_t most_rows) const {
  return std::make_unique<nets::DenseChain<float>>(parameters, encoder_name, most_rows);
}

std::unique_ptr<Coder::Network> DenseCoder::decoder(const std::shared_ptr<Parameters>& parameters,
                                                    std::int64_t most_rows) const {
  return std::make_unique<nets::DenseChain<float>>(parameters, decoder_name, most_rows);
}

}  // namespace piae::twin

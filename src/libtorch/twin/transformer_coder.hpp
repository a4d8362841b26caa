#pragma once

#include "libtorch/twin/coder.hpp"
#include "twin/transformer_coder.hpp"

namespace piae::libtorch {

/// Encoder and decoder of `piae-dt-transformer` (twin/transformer_coder.hpp).
class TransformerCoder final : public Coder {
 public:
  /// Throws like twin::TransformerCoder().
  TransformerCoder(const twin::NetworkShape& shape, const twin::TwinOptions& options)
      : tokens_(shape.samples / twin::TransformerCoder::frame), layers_(shape, options) {}

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override { return layers_.specs(); }
  [[nodiscard]] torch::Tensor encode(const ParameterSet& parameters,
                                     const torch::Tensor& x) const override;
  [[nodiscard]] torch::Tensor decode(const ParameterSet& parameters,
                                     const torch::Tensor& input) const override;

 private:
  /// Applies the positions, the blocks and the last normalisation: [batch, tokens, width] -> same
  /// shape.
  [[nodiscard]] torch::Tensor run_blocks(const ParameterSet& parameters, const std::string& network,
                                         torch::Tensor x) const;

  std::int64_t tokens_;
  twin::TransformerCoder layers_;
};

}  // namespace piae::libtorch

#pragma once

#include "libtorch/twin/coder.hpp"
#include "twin/temporal_coder.hpp"

namespace piae::libtorch {

/// Encoder and decoder of `piae-dt-tcn` (twin/temporal_coder.hpp).
class TemporalCoder final : public Coder {
 public:
  /// Throws like twin::TemporalCoder().
  TemporalCoder(const twin::NetworkShape& shape, const twin::TwinOptions& options)
      : layers_(shape, options) {}

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override { return layers_.specs(); }
  [[nodiscard]] torch::Tensor encode(const ParameterSet& parameters,
                                     const torch::Tensor& x) const override;
  [[nodiscard]] torch::Tensor decode(const ParameterSet& parameters,
                                     const torch::Tensor& input) const override;

 private:
  /// [batch, channels, positions] -> same shape.
  [[nodiscard]] torch::Tensor run_blocks(const ParameterSet& parameters, const std::string& network,
                                         torch::Tensor x) const;

  twin::TemporalCoder layers_;
};

}  // namespace piae::libtorch

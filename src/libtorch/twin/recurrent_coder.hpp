#pragma once

#include "libtorch/twin/coder.hpp"
#include "twin/recurrent_coder.hpp"

namespace piae::libtorch {

/// twin::RecurrentCoder by LibTorch's gru.
class RecurrentCoder final : public Coder {
 public:
  RecurrentCoder(const twin::NetworkShape& shape, const twin::TwinOptions& options)
      : sizes_(shape, options) {}

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override { return sizes_.specs(); }
  [[nodiscard]] torch::Tensor encode(const ParameterSet& parameters,
                                     const torch::Tensor& x) const override;
  [[nodiscard]] torch::Tensor decode(const ParameterSet& parameters,
                                     const torch::Tensor& input) const override;

 private:
  /// Returns the states of the last recurrent layer: [batch, frames, inputs] -> [batch, frames,
  /// units].
  [[nodiscard]] torch::Tensor run_gru(const ParameterSet& parameters, const std::string& name,
                                      const torch::Tensor& x) const;

  twin::RecurrentCoder sizes_;
};

}  // namespace piae::libtorch

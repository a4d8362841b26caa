#pragma once

#include "libtorch/twin/coder.hpp"
#include "twin/options.hpp"

namespace piae::libtorch {

/// Encoder and decoder of PIAE-DT itself (twin::DenseCoder). Windows may have any length.
class DenseCoder final : public Coder {
 public:
  DenseCoder(const twin::NetworkShape& shape, const twin::TwinOptions& options)
      : shape_(shape), options_(options) {}

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  [[nodiscard]] torch::Tensor encode(const ParameterSet& parameters,
                                     const torch::Tensor& x) const override;
  [[nodiscard]] torch::Tensor decode(const ParameterSet& parameters,
                                     const torch::Tensor& input) const override;

 private:
  twin::NetworkShape shape_;
  twin::TwinOptions options_;
};

}  // namespace piae::libtorch

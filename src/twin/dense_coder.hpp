#pragma once

#include "twin/coder.hpp"
#include "twin/options.hpp"

namespace piae::twin {

/// Encoder and decoder of PIAE-DT itself (specs.hpp). Windows may have any length.
class DenseCoder final : public Coder {
 public:
  DenseCoder(const NetworkShape& shape, const TwinOptions& options)
      : shape_(shape), options_(options) {}

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  [[nodiscard]] torch::Tensor encode(const nets::ParameterSet& parameters,
                                     const torch::Tensor& x) const override;
  [[nodiscard]] torch::Tensor decode(const nets::ParameterSet& parameters,
                                     const torch::Tensor& input) const override;

 private:
  NetworkShape shape_;
  TwinOptions options_;
};

}  // namespace piae::twin

#pragma once

#include "libtorch/twin/coder.hpp"
#include "twin/convolutional_coder.hpp"

namespace piae::libtorch {

/// Encoder and decoder of Model 4; twin::ConvolutionalCoder holds their sizes.
class ConvolutionalCoder final : public Coder {
 public:
  ConvolutionalCoder(const twin::NetworkShape& shape, const twin::TwinOptions& options)
      : own_(shape, options) {}

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override { return own_.specs(); }
  [[nodiscard]] torch::Tensor encode(const ParameterSet& parameters,
                                     const torch::Tensor& x) const override;
  [[nodiscard]] torch::Tensor decode(const ParameterSet& parameters,
                                     const torch::Tensor& input) const override;

 private:
  twin::ConvolutionalCoder own_;
};

}  // namespace piae::libtorch

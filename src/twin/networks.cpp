#include "twin/networks.hpp"

#include <stdexcept>

#include "nets/dense.hpp"
#include "nets/torch.hpp"
#include "twin/convolutional_coder.hpp"
#include "twin/dense_coder.hpp"
#include "twin/recurrent_coder.hpp"
#include "twin/specs.hpp"

namespace piae::twin {

namespace {

std::unique_ptr<Coder> make_coder(CoderKind kind, const NetworkShape& shape,
                                  const TwinOptions& options) {
  switch (kind) {
    case CoderKind::dense:
      return std::make_unique<DenseCoder>(shape, options);
    case CoderKind::convolutional:
      return std::make_unique<ConvolutionalCoder>(shape, options);
    case CoderKind::recurrent:
      return std::make_unique<RecurrentCoder>(shape, options);
  }
  throw std::logic_error("no such coder");
}

/// Times of the samples, from 0 to 1 over the window, one row a window.
torch::Tensor times_like(const torch::Tensor& acceleration) {
  return torch::linspace(0, 1, acceleration.size(1), acceleration.options())
      .expand({acceleration.size(0), -1});
}

}  // namespace

Networks::Networks(const TwinVariant& variant, const NetworkShape& shape,
                   const TwinOptions& options)
    : variant_(variant),
      shape_(shape),
      options_(options),
      coder_(make_coder(variant.coder, shape, options)) {}

std::vector<nets::ParameterSpec> Networks::specs() const {
  return network_specs(variant_, shape_, options_, coder_->specs());
}

torch::Tensor Networks::encode(const nets::ParameterSet& parameters, const torch::Tensor& x) const {
  return torch::softplus(coder_->encode(parameters, x));
}

torch::Tensor Networks::decode(const nets::ParameterSet& parameters, const torch::Tensor& k_and_c,
                               const torch::Tensor& label) const {
  return coder_->decode(parameters, torch::cat({k_and_c, label}, 1));
}

Motion Networks::move(const nets::ParameterSet& parameters,
                      const torch::Tensor& acceleration) const {
  const torch::Tensor input = torch::cat({acceleration, times_like(acceleration)}, 1);
  const std::vector<torch::Tensor> halves =
      nets::run_dense_chain(parameters, module_name, input).chunk(2, 1);
  return {halves[0], halves[1]};
}

}  // namespace piae::twin

#include "libtorch/twin/networks.hpp"

#include <stdexcept>

#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/torch.hpp"
#include "libtorch/twin/convolutional_coder.hpp"
#include "libtorch/twin/dense_coder.hpp"
#include "libtorch/twin/recurrent_coder.hpp"
#include "libtorch/twin/temporal_coder.hpp"
#include "libtorch/twin/transformer_coder.hpp"
#include "twin/specs.hpp"

namespace piae::libtorch {

namespace {

std::unique_ptr<Coder> make_coder(twin::CoderKind kind, const twin::NetworkShape& shape,
                                  const twin::TwinOptions& options) {
  switch (kind) {
    case twin::CoderKind::dense:
      return std::make_unique<DenseCoder>(shape, options);
    case twin::CoderKind::convolutional:
      return std::make_unique<ConvolutionalCoder>(shape, options);
    case twin::CoderKind::recurrent:
      return std::make_unique<RecurrentCoder>(shape, options);
    case twin::CoderKind::temporal:
      return std::make_unique<TemporalCoder>(shape, options);
    case twin::CoderKind::transformer:
      return std::make_unique<TransformerCoder>(shape, options);
  }
  throw std::logic_error("unknown coder");
}

/// Returns the times of the samples, from 0 to 1 over the window, one row per window.
torch::Tensor times_like(const torch::Tensor& acceleration) {
  return torch::linspace(0, 1, acceleration.size(1), acceleration.options())
      .expand({acceleration.size(0), -1});
}

}  // namespace

Networks::Networks(const twin::TwinVariant& variant, const twin::NetworkShape& shape,
                   const twin::TwinOptions& options)
    : variant_(variant),
      shape_(shape),
      options_(options),
      coder_(libtorch::make_coder(variant.coder, shape, options)) {}

std::vector<nets::ParameterSpec> Networks::specs() const {
  return twin::network_specs(variant_, shape_, options_, coder_->specs());
}

torch::Tensor Networks::encode(const ParameterSet& parameters, const torch::Tensor& x) const {
  const torch::Tensor any = coder_->encode(parameters, x);
  return options_.positive == twin::Positive::softplus ? torch::softplus(any) : any.exp();
}

torch::Tensor Networks::decode(const ParameterSet& parameters, const torch::Tensor& k_and_c,
                               const torch::Tensor& label) const {
  return coder_->decode(parameters, torch::cat({k_and_c, label}, 1));
}

Motion Networks::move(const ParameterSet& parameters, const torch::Tensor& acceleration) const {
  const torch::Tensor input = torch::cat({acceleration, times_like(acceleration)}, 1);
  const std::vector<torch::Tensor> halves =
      run_dense_chain(parameters, twin::module_name, input).chunk(2, 1);
  return {.displacement = halves[0], .velocity = halves[1]};
}

}  // namespace piae::libtorch

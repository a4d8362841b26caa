#include "libtorch/latent/vae_losses.hpp"

#include "latent/specs.hpp"
#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

torch::Tensor kl_to_standard_normal(const torch::Tensor& mean, const torch::Tensor& log_variance) {
  return 0.5 * (mean.square() + log_variance.exp() - 1 - log_variance).sum(1).mean();
}

VaeLosses vae_losses(const ParameterSet& parameters, const Batch& batch,
                     const torch::Tensor& noise) {
  const torch::Tensor input = torch::cat({batch.windows, batch.classes}, 1);
  const std::vector<torch::Tensor> posterior =
      run_dense_chain(parameters, latent::encoder_name, input).chunk(2, 1);
  const torch::Tensor& mean = posterior[0];
  const torch::Tensor& log_variance = posterior[1];
  const torch::Tensor z = mean + (0.5 * log_variance).exp() * noise;
  const torch::Tensor error = run_generator(parameters, z, batch.classes) - batch.windows;
  return {.squared_error = 0.5 * error.square().sum(1).mean(),
          .kl = kl_to_standard_normal(mean, log_variance)};
}

}  // namespace piae::libtorch

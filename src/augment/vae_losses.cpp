#include "augment/vae_losses.hpp"

#include "augment/latent_specs.hpp"
#include "nets/dense.hpp"
#include "nets/torch.hpp"

namespace piae::augment {

torch::Tensor kl_to_standard_normal(const torch::Tensor& mean, const torch::Tensor& log_variance) {
  return 0.5 * (mean.square() + log_variance.exp() - 1 - log_variance).sum(1).mean();
}

VaeLosses vae_losses(const nets::ParameterSet& parameters, const Batch& batch,
                     const torch::Tensor& noise) {
  const torch::Tensor input = torch::cat({batch.windows, batch.classes}, 1);
  const std::vector<torch::Tensor> posterior =
      nets::run_dense_chain(parameters, encoder_name, input).chunk(2, 1);
  const torch::Tensor& mean = posterior[0];
  const torch::Tensor& log_variance = posterior[1];
  const torch::Tensor z = mean + (0.5 * log_variance).exp() * noise;
  const torch::Tensor error = run_generator(parameters, z, batch.classes) - batch.windows;
  return {0.5 * error.square().sum(1).mean(), kl_to_standard_normal(mean, log_variance)};
}

}  // namespace piae::augment

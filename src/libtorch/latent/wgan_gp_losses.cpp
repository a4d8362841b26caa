#include "libtorch/latent/wgan_gp_losses.hpp"

#include "latent/specs.hpp"
#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

torch::Tensor run_critic(const ParameterSet& parameters, const torch::Tensor& windows,
                         const torch::Tensor& classes) {
  return run_dense_chain(parameters, latent::critic_name, torch::cat({windows, classes}, 1))
      .squeeze(1);
}

torch::Tensor gradient_penalty(const ParameterSet& parameters, const torch::Tensor& windows,
                               const torch::Tensor& classes) {
  const torch::Tensor at = windows.detach().requires_grad_();
  // A score depends only on its own window, so the gradient of the sum of all scores contains each
  // score's gradient.
  const torch::Tensor gradients =
      torch::autograd::grad({run_critic(parameters, at, classes).sum()}, {at}, {},
                            /*retain_graph=*/true, /*create_graph=*/true)[0];
  return (gradients.norm(2, 1) - 1).square().mean();
}

CriticLosses critic_losses(const ParameterSet& parameters, const Batch& known,
                           const torch::Tensor& generated, const torch::Tensor& share) {
  const torch::Tensor between = generated + share * (known.windows - generated);
  const torch::Tensor scores = run_critic(parameters, known.windows, known.classes) -
                               run_critic(parameters, generated, known.classes);
  return {.wasserstein = scores.mean(),
          .penalty = gradient_penalty(parameters, between, known.classes)};
}

}  // namespace piae::libtorch

#pragma once

#include <memory>

#include "base/compute.hpp"
#include "latent/backend.hpp"
#include "latent/wgan_gp_options.hpp"

namespace piae::latent {

/// The critic minimises -wasserstein + lambda * penalty in every step; after each `critic_steps` of
/// them, counted over the whole training, the generator takes one to maximise the mean score of its
/// windows (Gulrajani et al. 2017, Algorithm 1). A step returns wasserstein and penalty.
/// The task must outlive it.
using MakeWganGp = std::unique_ptr<LatentBackend> (*)(const LatentTask& task,
                                                      const WganGpOptions& options,
                                                      const Stream& initial,
                                                      Device device);

/// Ours, for one core.
std::unique_ptr<LatentBackend> wgan_gp(const LatentTask& task, const WganGpOptions& options,
                                       const Stream& initial, Device device);

/// Adam's decay rates. Gulrajani et al. print beta_1 = 0 (Algorithm 1); their published code for
/// dense and small networks (gan_toy.py, gan_mnist.py) and most work since has 0.5.
inline constexpr double wgan_gp_beta1 = 0.5;
inline constexpr double wgan_gp_beta2 = 0.9;

}  // namespace piae::latent

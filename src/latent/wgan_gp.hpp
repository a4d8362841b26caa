#pragma once

#include <memory>

#include "base/compute.hpp"
#include "latent/backend.hpp"
#include "latent/wgan_gp_options.hpp"

namespace piae::latent {

/// Makes a back end of the conditional WGAN-GP (Gulrajani et al. 2017, Algorithm 1). In every step
/// the critic minimises -wasserstein + lambda * penalty. After every `critic_steps` steps, counted
/// over the whole training, the generator takes one step to maximise the mean score of its windows.
/// A step returns:
///  - wasserstein: the mean score of the known windows minus that of the generated ones;
///  - penalty: the mean of (|gradient of the score by the window| - 1)^2 over windows between known
/// and generated ones.
/// The back end owns the task; initial values come from `initial`.
using MakeWganGp = std::unique_ptr<LatentBackend> (*)(LatentTask task, const WganGpOptions& options,
                                                      const Stream& initial, Device device);

/// Our own back end, for one core.
std::unique_ptr<LatentBackend> wgan_gp(LatentTask task, const WganGpOptions& options,
                                       const Stream& initial, Device device);

/// Decay rates of Adam. Gulrajani et al. print beta_1 = 0 (Algorithm 1), but their published code
/// for dense and small networks (gan_toy.py, gan_mnist.py) and most later work use 0.5.
inline constexpr double wgan_gp_beta1 = 0.5;
inline constexpr double wgan_gp_beta2 = 0.9;

}  // namespace piae::latent

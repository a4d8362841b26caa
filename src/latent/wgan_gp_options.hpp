#pragma once

#include "cli/options.hpp"
#include "latent/options.hpp"

namespace piae::latent {

/// The settings of the WGAN-GP. The paper says no more than its name; where each value comes from
/// stands in pipeline/protocol.toml, [train.wgan-gp].
struct WganGpOptions {
  LatentOptions networks{
      .epochs = 1000,         // calibrated
      .batch = 5,             // as PIAE-DT, the paper's Table 4
      .learning_rate = 1e-4,  // Gulrajani et al. 2017, Algorithm 1
      .latent = 20,           // our choice
      .depth = 3,             // as PIAE-DT
      .width = 256,           // as PIAE-DT
  };
  int critic_steps = 5;  ///< for each step of the generator; Gulrajani et al., Algorithm 1
  double penalty = 10;   ///< lambda, weight of the gradient penalty; Gulrajani et al., Algorithm 1
};

void bind(const cli::Options& command, WganGpOptions& options);

}  // namespace piae::latent

#pragma once

#include "cli/options.hpp"
#include "latent/options.hpp"

namespace piae::latent {

/// Settings of the WGAN-GP. The paper gives only its name; pipeline/protocol.toml, [train.wgan-gp],
/// gives the source of each value.
struct WganGpOptions {
  LatentOptions networks{
      .epochs = 1000,         // calibrated
      .batch = 5,             // like PIAE-DT, the paper's Table 4
      .learning_rate = 1e-4,  // Gulrajani et al. 2017, Algorithm 1
      .latent = 20,           // our choice
      .depth = 3,             // like PIAE-DT
      .width = 256,           // like PIAE-DT
  };
  int critic_steps = 5;  ///< per step of the generator; Gulrajani et al., Algorithm 1
  double penalty = 10;   ///< lambda, weight of the gradient penalty; Gulrajani et al., Algorithm 1
};

void bind(const cli::Options& command, WganGpOptions& options);

}  // namespace piae::latent

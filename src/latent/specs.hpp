#pragma once

#include <string>
#include <vector>

#include "latent/generator.hpp"

namespace piae::latent {

// Networks that are trained beside a LatentGenerator, dense chains of its size.

/// Of a VAE: window and one-hot class [N + classes] -> mean and log variance of z [2 latent].
inline const std::string encoder_name = "net/encoder";
std::vector<nets::ParameterSpec> vae_specs(const LatentGenerator& generator);

/// Of a GAN: window and one-hot class [N + classes] -> score [1]. No normalisation: a window's
/// score, and so its gradient, must not depend on the rest of its batch.
inline const std::string critic_name = "net/critic";
std::vector<nets::ParameterSpec> wgan_gp_specs(const LatentGenerator& generator);

}  // namespace piae::latent

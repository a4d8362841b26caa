#pragma once

#include <string>
#include <vector>

#include "latent/generator.hpp"

namespace piae::latent {

// Training a LatentGenerator needs a second network, a chain of dense layers of the same size. The
// functions below return the parameters of both.

/// The VAE's encoder: window and one-hot class [N + classes] -> mean and log variance of z
/// [2 latent].
inline const std::string encoder_name = "net/encoder";
std::vector<nets::ParameterSpec> vae_specs(const LatentGenerator& generator);

/// The GAN's critic: window and one-hot class [N + classes] -> score [1]. It has no normalisation,
/// because a window's score and its gradient must not depend on the rest of the batch.
inline const std::string critic_name = "net/critic";
std::vector<nets::ParameterSpec> wgan_gp_specs(const LatentGenerator& generator);

}  // namespace piae::latent

#pragma once

#include <memory>

#include "artefact/reader.hpp"
#include "base/compute.hpp"
#include "latent/backend.hpp"
#include "latent/generator.hpp"
#include "latent/wgan_gp_options.hpp"

namespace piae::libtorch {

// VAE and WGAN-GP by LibTorch's eager operations: what latent/vae.hpp, latent/wgan_gp.hpp and
// latent/generator.hpp describe.

std::unique_ptr<latent::LatentBackend> vae(const latent::LatentTask& task, const Stream& initial,
                                           Device device);
std::unique_ptr<latent::LatentBackend> wgan_gp(const latent::LatentTask& task,
                                               const latent::WganGpOptions& options,
                                               const Stream& initial, Device device);
std::unique_ptr<latent::StoredGenerator> open_generator(const artefact::Reader& model,
                                                        const latent::LatentGenerator& generator,
                                                        Device device);

}  // namespace piae::libtorch

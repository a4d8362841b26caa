#pragma once

#include <memory>

#include "artefact/reader.hpp"
#include "base/compute.hpp"
#include "latent/backend.hpp"
#include "latent/generator.hpp"
#include "latent/wgan_gp_options.hpp"

namespace piae::libtorch {

// VAE and WGAN-GP by LibTorch's eager operations. latent/vae.hpp (MakeVae), latent/wgan_gp.hpp
// (MakeWganGp) and latent/generator.hpp (OpenGenerator) describe the results. All functions throw
// Error(usage) for cuda if LibTorch finds no such device.

std::unique_ptr<latent::LatentBackend> vae(latent::LatentTask task, const Stream& initial,
                                           Device device);
std::unique_ptr<latent::LatentBackend> wgan_gp(latent::LatentTask task,
                                               const latent::WganGpOptions& options,
                                               const Stream& initial, Device device);
std::unique_ptr<latent::StoredGenerator> open_generator(const artefact::Reader& model,
                                                        const latent::LatentGenerator& generator,
                                                        Device device);

}  // namespace piae::libtorch

#pragma once

#include <memory>

#include "base/compute.hpp"
#include "latent/backend.hpp"

namespace piae::latent {

/// Minimises the negative evidence bound over all parameters (Kingma and Welling 2014). A step
/// returns its two parts, squared error and KL divergence. The task must outlive it.
using MakeVae = std::unique_ptr<LatentBackend> (*)(const LatentTask& task, const Stream& initial,
                                                   Device device);

/// Ours, for one core.
std::unique_ptr<LatentBackend> vae(const LatentTask& task, const Stream& initial, Device device);

}  // namespace piae::latent

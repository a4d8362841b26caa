#pragma once

#include <memory>
#include <string>

#include "augment/latent_backend.hpp"

namespace piae::augment {

/// Minimises the negative evidence bound over all parameters (Kingma and Welling 2014). A step
/// returns its two parts, squared error and KL divergence. The task must outlive it.
using MakeVae = std::unique_ptr<LatentBackend> (*)(const LatentTask& task, const Stream& initial,
                                                   const std::string& device);

/// By LibTorch's eager operations.
std::unique_ptr<LatentBackend> libtorch_vae(const LatentTask& task, const Stream& initial,
                                            const std::string& device);
/// Ours, for one core.
std::unique_ptr<LatentBackend> native_vae(const LatentTask& task, const Stream& initial,
                                          const std::string& device);

}  // namespace piae::augment

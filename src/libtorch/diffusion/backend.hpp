#pragma once

#include <torch/types.h>

#include <memory>

#include "base/compute.hpp"
#include "diffusion/backend.hpp"
#include "libtorch/nets/parameters.hpp"

namespace piae::libtorch {

/// Runs a denoiser: windows [n, N], places u [n] and one-hot classes [n, classes], 0 for no class,
/// -> velocities [n, N].
torch::Tensor run_denoiser(const diffusion::Denoiser& denoiser, const ParameterSet& parameters,
                           const torch::Tensor& windows, const torch::Tensor& u,
                           const torch::Tensor& classes);

/// Diffusion and flow models by LibTorch's eager operations (MakeDiffusionBackend). Throws
/// Error(usage) for cuda if LibTorch finds no such device.
std::unique_ptr<diffusion::DiffusionBackend> diffusion_backend(const diffusion::Networks& networks,
                                                               std::int64_t most_windows,
                                                               const Stream& initial,
                                                               Device device);

}  // namespace piae::libtorch

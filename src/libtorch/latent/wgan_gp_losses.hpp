#pragma once

#include <torch/types.h>

#include "libtorch/latent/shared.hpp"

namespace piae::libtorch {

/// Returns the critic's scores [n] of windows [n, N] with one-hot classes [n, classes].
torch::Tensor run_critic(const ParameterSet& parameters, const torch::Tensor& windows,
                         const torch::Tensor& classes);

/// Returns the mean over the windows of (|gradient of the score by the window| - 1)^2. The result
/// is differentiable by the critic's parameters.
torch::Tensor gradient_penalty(const ParameterSet& parameters, const torch::Tensor& windows,
                               const torch::Tensor& classes);

/// The two parts of the critic's loss (latent/wgan_gp.hpp).
struct CriticLosses {
  torch::Tensor wasserstein;  ///< mean score of the known minus that of the generated windows
  torch::Tensor penalty;      ///< gradient_penalty on the lines between these windows
};

/// Returns the losses for known and generated windows; row i of both has the same class. `share`
/// [n, 1] is the position of the penalty on the line from the generated (0) to the known (1)
/// window.
CriticLosses critic_losses(const ParameterSet& parameters, const Batch& known,
                           const torch::Tensor& generated, const torch::Tensor& share);

}  // namespace piae::libtorch

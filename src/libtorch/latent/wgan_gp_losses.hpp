#pragma once

#include <torch/types.h>

#include <vector>

#include "libtorch/latent/shared.hpp"

namespace piae::libtorch {

/// Scores of windows [n, N] of one-hot classes [n, classes]: [n].
torch::Tensor run_critic(const ParameterSet& parameters, const torch::Tensor& windows,
                         const torch::Tensor& classes);

/// Mean over the windows of (|gradient of the score with respect to the window| - 1)^2. Itself
/// differentiable with respect to the critic's parameters.
torch::Tensor gradient_penalty(const ParameterSet& parameters, const torch::Tensor& windows,
                               const torch::Tensor& classes);

struct CriticLosses {
  torch::Tensor wasserstein;  ///< mean score of the known minus that of the generated windows
  torch::Tensor penalty;      ///< gradient_penalty on the lines between them
};

/// `generated` has the classes of the batch, row by row. `share` [n, 1], in [0, 1]: where between a
/// generated (0) and a known (1) window the gradient is taken.
CriticLosses critic_losses(const ParameterSet& parameters, const Batch& known,
                           const torch::Tensor& generated, const torch::Tensor& share);

}  // namespace piae::libtorch

#pragma once

#include <torch/types.h>

#include "libtorch/latent/shared.hpp"

namespace piae::libtorch {

/// The two parts of the negative evidence bound (latent/vae.hpp), each the mean over the batch.
struct VaeLosses {
  torch::Tensor squared_error;  ///< 1/2 |x - x^|^2
  torch::Tensor kl;             ///< KL(q(z|x) || N(0, 1))
};

/// Returns the losses of a batch at z = mean + sigma * noise, for noise [n, latent] from N(0, 1).
VaeLosses vae_losses(const ParameterSet& parameters, const Batch& batch,
                     const torch::Tensor& noise);

/// Returns KL(N(mean, exp(log_variance)) || N(0, 1)) for [n, latent]: the sum over the columns,
/// averaged over the rows.
torch::Tensor kl_to_standard_normal(const torch::Tensor& mean, const torch::Tensor& log_variance);

}  // namespace piae::libtorch

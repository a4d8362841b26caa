#pragma once

#include <torch/types.h>

#include <vector>

#include "libtorch/latent/shared.hpp"

namespace piae::libtorch {

/// The two parts of the negative evidence bound, per window (mean over the batch).
struct VaeLosses {
  torch::Tensor squared_error;  ///< 1/2 |x - x^|^2: a Gaussian of variance 1 around the decoded x^
  torch::Tensor kl;             ///< KL(q(z|x) || N(0, 1))
};

/// z = mean + sigma * noise, the noise N(0, 1) of shape [n, latent].
VaeLosses vae_losses(const ParameterSet& parameters, const Batch& batch,
                     const torch::Tensor& noise);

/// KL(N(mean, exp(log_variance)) || N(0, 1)), summed over the columns of [n, latent], mean over the
/// rows.
torch::Tensor kl_to_standard_normal(const torch::Tensor& mean, const torch::Tensor& log_variance);

}  // namespace piae::libtorch

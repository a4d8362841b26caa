#pragma once

#include <torch/types.h>

#include "libtorch/twin/networks.hpp"
#include "twin/physics.hpp"

namespace piae::libtorch {

/// Biased squared maximum mean discrepancy between two batches [n, N] and [m, N]: five Gaussian
/// kernels exp(-d^2 / b), b = mean squared distance of the pooled batch / 4 * {1, 2, 4, 8, 16},
/// summed (the convention of the field, after Gretton et al. 2012). Differentiable, also through b.
torch::Tensor batch_mmd(const torch::Tensor& x, const torch::Tensor& y);

/// L_Rec, eq. 20: mean squared error of the decoded acceleration, plus their MMD.
torch::Tensor reconstruction_loss(const torch::Tensor& x, const torch::Tensor& a);

/// L_DDL, eq. 21: the second derivative of displacement and the first of velocity against the
/// acceleration, as mean squares and as MMD. Derivatives are central differences over the inner
/// samples; `step` is the dimensionless time between samples.
torch::Tensor differential_loss(const Motion& motion, const torch::Tensor& a, double step);

/// What eq. 22 needs of each window of a batch, as [batch, 1] tensors.
struct BatchPhysics {
  torch::Tensor deflection;    ///< delta of the window's class, m
  torch::Tensor displacement;  ///< u_ref = a_ref / omega_0^2, m
  torch::Tensor force;         ///< M * a_ref, N
};
BatchPhysics batch_physics(const twin::Physics& physics, const torch::Tensor& labels,
                           const torch::TensorOptions& type);

/// L_DT, eq. 22: mean square of the dimensionless equation of motion (twin/physics.hpp) over the
/// batch, for k~ and c~ as [batch, 2]. Differentiable in k~ also through the static equilibrium.
torch::Tensor twin_loss(const torch::Tensor& k_and_c, const torch::Tensor& a, const Motion& motion,
                        const BatchPhysics& batch, const twin::Physics& physics);

/// alpha L_DDL + beta L_DT + gamma L_Rec for log_weights = (log alpha, log beta, log gamma): eq. 23
/// without its logarithms. Where the weights are learned by it, nothing holds them above zero.
torch::Tensor weighted_loss(const torch::Tensor& differential, const torch::Tensor& twin,
                            const torch::Tensor& reconstruction, const torch::Tensor& log_weights);

/// L_total, eq. 23. Its stationary point is at alpha = 1 / (2 L_DDL), beta = 1 / (2 L_DT), gamma =
/// 1 / (2 L_Rec).
torch::Tensor total_loss(const torch::Tensor& differential, const torch::Tensor& twin,
                         const torch::Tensor& reconstruction, const torch::Tensor& log_weights);

}  // namespace piae::libtorch

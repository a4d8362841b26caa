#pragma once

#include <torch/types.h>

#include "libtorch/twin/networks.hpp"
#include "twin/derivatives.hpp"
#include "twin/losses.hpp"
#include "twin/physics.hpp"

namespace piae::libtorch {

// The losses of twin/losses.hpp, with gradients by autograd.

/// Returns the biased squared maximum mean discrepancy between two batches [n, N] and [m, N]
/// (twin::add_batch_mmd()). Differentiable, also through the bandwidth.
torch::Tensor batch_mmd(const torch::Tensor& x, const torch::Tensor& y);

/// L_Rec, eq. 20: returns the mean squared error of the decoded acceleration a, plus the MMD of a
/// and x.
torch::Tensor reconstruction_loss(const torch::Tensor& x, const torch::Tensor& a,
                                  const twin::LossInterpretation& interpretation = {});

/// L_DDL, eq. 21: compares the second derivative of the displacement and the first derivative of
/// the velocity with the acceleration, by squares and by MMD, at the samples that the stencil
/// reaches. `step` is the dimensionless time between two samples.
torch::Tensor differential_loss(const Motion& motion, const torch::Tensor& a, double step,
                                const twin::Stencil& stencil,
                                const twin::LossInterpretation& interpretation = {});

/// Constants of eq. 22 for each window of a batch, as tensors [batch, 1] except where noted.
struct BatchPhysics {
  torch::Tensor outside;       ///< delta while no ball is in the defect, m
  torch::Tensor inside;        ///< delta while a ball is in the defect, m
  torch::Tensor at_rest;       ///< w of twin::Contact at the static equilibrium
  torch::Tensor passing;       ///< w of each sample, [batch, N], or like at_rest
  torch::Tensor displacement;  ///< u_ref = a_ref / omega_0^2, m
  torch::Tensor force;         ///< M * a_ref, N
};
BatchPhysics batch_physics(const twin::Physics& physics, const torch::Tensor& labels,
                           const torch::TensorOptions& type);

/// L_DT, eq. 22: returns the square or the absolute value of the dimensionless equation of motion
/// (twin/physics.hpp) over the batch, for (k~, c~) [batch, 2]. Differentiable in k~ also through
/// the static equilibrium.
torch::Tensor twin_loss(const torch::Tensor& k_and_c, const torch::Tensor& a, const Motion& motion,
                        const BatchPhysics& batch, const twin::Physics& physics,
                        const twin::LossInterpretation& interpretation = {});

}  // namespace piae::libtorch

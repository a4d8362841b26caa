#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "base/label.hpp"
#include "nets/row_array.hpp"
#include "twin/derivatives.hpp"
#include "twin/options.hpp"
#include "twin/physics.hpp"

namespace piae::twin {

using nets::RowArray;

/// Kernels of the MMD: the factors on its bandwidth, and the smallest bandwidth.
inline constexpr std::array<double, 5> mmd_kernel_factors{1, 2, 4, 8, 16};
inline constexpr double mmd_least_bandwidth = 1e-12;
/// Below this squared MMD its root is constant, because its slope would be unbounded.
inline constexpr double mmd_least_squared = 1e-12;

/// A loss, and its gradients by its inputs. A gradient is empty if the loss does not depend on the
/// input.
template <class T>
struct LossOf {
  double value = 0;
  RowArray<T> by_acceleration;  ///< [batch, N]
  RowArray<T> by_displacement;  ///< [batch, N]
  RowArray<T> by_velocity;      ///< [batch, N]
  RowArray<T> by_k_and_c;       ///< [batch, 2]
};

/// Returns the biased squared maximum mean discrepancy between two batches x [n, N] and y [m, N]:
/// the sum of five Gaussian kernels exp(-d^2 / b), with b = mean squared distance within the pooled
/// batch / 4 * {1, 2, 4, 8, 16} (the convention of the field, after Gretton et al. 2012). Adds its
/// gradients, also through b, to `by_x` (unless it is null) and `by_y`.
template <class T>
double add_batch_mmd(const RowArray<T>& x, const RowArray<T>& y, RowArray<T>* by_x,
                     RowArray<T>& by_y);

/// Interpretation of the norms and the MMD of eqs 20 to 22. `squares` also selects whether the
/// residual of eq. 22 is averaged or summed over the samples of a window.
struct LossInterpretation {
  Squares squares = Squares::mean;
  Mmd mmd = Mmd::squared;
  Residual residual = Residual::squared;
};

/// L_Rec, eq. 20: returns the squared error of the decoded acceleration a for the windows x, plus
/// their MMD; both are [batch, N].
template <class T>
LossOf<T> reconstruction_loss(const RowArray<T>& x, const RowArray<T>& a,
                              const LossInterpretation& interpretation = {});

/// Displacement, velocity and acceleration of a batch, dimensionless, [batch, N].
template <class T>
struct BatchMotion {
  RowArray<T> displacement;
  RowArray<T> velocity;
  RowArray<T> acceleration;
};

/// L_DDL, eq. 21: compares the second derivative of the displacement and the first derivative of
/// the velocity with the acceleration, by squares and by MMD, at the samples that the stencil
/// reaches. `step` is the dimensionless time between two samples.
template <class T>
LossOf<T> differential_loss(const BatchMotion<T>& motion, double step, const Stencil& stencil,
                            const LossInterpretation& interpretation = {});

/// L_DT, eq. 22: returns the square or the absolute value of the dimensionless equation of motion
/// (physics.hpp), for (k~, c~) [batch, 2]. The gradient by k~ includes the static equilibrium.
template <class T>
LossOf<T> twin_loss(const RowArray<T>& k_and_c, const BatchMotion<T>& motion,
                    std::span<const Label> labels, const Physics& physics,
                    const LossInterpretation& interpretation = {});

/// One number for each loss of eq. 23, in this order: L_DDL (alpha), L_DT (beta), L_Rec (gamma).
template <class T>
using PerLoss = std::array<T, 3>;

/// Returns L_total, eq. 23: alpha L_DDL + beta L_DT + gamma L_Rec - (ln alpha + ln beta + ln gamma)
/// / 2, from the logarithms of the weights. Its minimum is at alpha = 1 / (2 L_DDL), and so on.
/// Without `has_logarithms` the last term is omitted; weights learned by that form only shrink.
/// Numbers may be LibTorch's tensors, which differentiate it.
template <class Loss, class Log>
Loss total_loss(const PerLoss<Loss>& losses, const PerLoss<Log>& log_weights,
                bool has_logarithms = true) {
  using std::exp;
  Loss total = exp(log_weights[0]) * losses[0] + exp(log_weights[1]) * losses[1] +
               exp(log_weights[2]) * losses[2];
  if (!has_logarithms) return total;
  for (const Log& log_weight : log_weights) total = total - 0.5 * log_weight;
  return total;
}

/// Returns the derivatives of total_loss() by the logarithms of the weights.
inline PerLoss<float> total_loss_by_log_weights(const PerLoss<double>& losses,
                                                const PerLoss<float>& log_weights,
                                                bool has_logarithms = true) {
  const double logarithm = has_logarithms ? 0.5 : 0;
  PerLoss<float> gradient{};
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    gradient[i] = static_cast<float>(std::exp(log_weights[i]) * losses[i] - logarithm);
  }
  return gradient;
}

}  // namespace piae::twin

#pragma once

#include <span>

#include "nets/row_array.hpp"
#include "twin/physics.hpp"

namespace piae::twin {

using nets::RowArray;

/// A loss, and its gradient by what it was computed from. What a loss does not depend on has an
/// empty gradient. The same mathematics as losses.hpp, with gradients written by hand.
template <class T>
struct LossOf {
  double value = 0;
  RowArray<T> by_acceleration;  ///< [batch, N]
  RowArray<T> by_displacement;  ///< [batch, N]
  RowArray<T> by_velocity;      ///< [batch, N]
  RowArray<T> by_k_and_c;       ///< [batch, 2]
};

/// Squared MMD of x and y, [batch, N] each, of losses.hpp; adds its gradients to those given.
template <class T>
double add_batch_mmd(const RowArray<T>& x, const RowArray<T>& y, RowArray<T>* by_x,
                     RowArray<T>& by_y);

/// L_Rec, eq. 20, of the decoded acceleration a for the windows x.
template <class T>
LossOf<T> reconstruction_loss(const RowArray<T>& x, const RowArray<T>& a);

/// Displacement, velocity and acceleration of a batch, dimensionless, [batch, N].
template <class T>
struct BatchMotion {
  RowArray<T> displacement;
  RowArray<T> velocity;
  RowArray<T> acceleration;
};

/// L_DDL, eq. 21.
template <class T>
LossOf<T> differential_loss(const BatchMotion<T>& motion, double step);

/// L_DT, eq. 22, for k~ and c~ as [batch, 2] and the windows' labels.
template <class T>
LossOf<T> twin_loss(const RowArray<T>& k_and_c, const BatchMotion<T>& motion,
                    std::span<const std::int32_t> labels, const Physics& physics);

}  // namespace piae::twin

#pragma once

#include "base/random.hpp"
#include "bearing/dynamics.hpp"

namespace piae::bearing {

/// Variation between the records of one bearing. Stiffness, damping and shaft speed are normal
/// about their means, with these relative standard deviations, cut off at 3 of them. A spread below
/// 1/3 keeps the values positive. The paper leaves this open: the spreads are the project's choice,
/// and a slip of cage and balls of up to 1 % is usual.
struct Variation {
  double stiffness_spread = 0.1;  ///< standard deviation of K / its mean
  double damping_spread = 0.2;    ///< standard deviation of C / its mean
  double speed_spread = 0.001;    ///< standard deviation of the shaft speed / its mean
  double slip_max = 0.01;         ///< slip is uniform from 0 to this value; below 1
};

/// Every spread must be below this.
inline constexpr double spread_limit = 1.0 / 3;

/// Returns the largest stiffness that can be drawn times the clearance, in N. The load must exceed
/// it; otherwise there may be windows in which no ball carries load.
double largest_lift_n(const DynamicsOptions& mean, const Variation& variation);

/// Draws stiffness and damping; copies everything else from `mean`.
DynamicsOptions draw_dynamics(Stream& stream, const DynamicsOptions& mean,
                              const Variation& variation);

/// Draws speed, slip and angles. A defect of the outer race is always in the middle of the load
/// zone; all other angles are uniform.
Motion draw_motion(Stream& stream, Defect defect, double mean_speed_rpm,
                   const Variation& variation);

}  // namespace piae::bearing

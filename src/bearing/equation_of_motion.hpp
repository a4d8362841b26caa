#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "bearing/loaded_balls.hpp"

namespace piae::bearing {

/// The displacement s in m, positive in the direction of the load, and its velocity in m/s.
struct State {
  PerCourse displacement;
  PerCourse velocity;
};

/// Eq. 13 for courses_at_once courses, with its contact term summed over the balls in the load
/// zone:
///     M s" + C s' + K s + K_b sum_j max(s cos(psi_j) - delta_j, 0)^1.5 cos(psi_j) = W.
/// The printed equation has one ball at a fixed place; a healthy bearing would then not vibrate.
struct EquationOfMotion {
  PerCourse mass_kg;
  PerCourse damping_ns_per_m;
  PerCourse stiffness_n_per_m;
  PerCourse contact_n_per_m15;  ///< K_b; 0 switches the contact off
  PerCourse load_n;

  /// Returns the force that accelerates the mass, M s", in N.
  [[nodiscard]] PerCourse force_n(const State& state, std::span<const BallContact> balls) const;
};

/// Returns the displacement, in m, at which the bearing carries the load at rest.
PerCourse static_equilibrium_m(const EquationOfMotion& equation,
                               std::span<const BallContact> balls);

/// Sampling of a signal: sample i covers the interval from i / rate to (i + 1) / rate.
struct Sampling {
  double rate_hz = 0;
  std::size_t samples = 0;
};

/// Division of a sampling interval into the sub-steps of the solution.
struct SubSteps {
  std::size_t count = 0;
  double step_s = 0;
};

/// The solutions of courses_at_once courses, one per lane.
struct Solution {
  /// Accelerations [samples], in m/s^2, averaged over each sampling interval. The average is exact,
  /// because it is the change of velocity over the interval. Averaging acts like the anti-aliasing
  /// filter of an accelerometer. It also makes samples change smoothly when a defect moves across
  /// the border of two samples.
  std::vector<PerCourse> acceleration;
  /// Number of samples before a course diverged; all samples if it did not.
  Vector<std::int64_t> sane_samples{};
};

/// Solves eq. 13 from `state` at time `start_s` by the classical Runge-Kutta method of order 4 with
/// fixed sub-steps. Leaves the last state in `state`. Samples after a course has diverged are
/// meaningless.
Solution solve(const EquationOfMotion& equation, LoadedBalls& balls, State& state, double start_s,
               const Sampling& sampling, const SubSteps& sub_steps);

}  // namespace piae::bearing

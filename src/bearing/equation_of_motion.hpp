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
/// As printed, the equation has one ball at a fixed place; a healthy bearing would then be silent.
struct EquationOfMotion {
  PerCourse mass_kg;
  PerCourse damping_ns_per_m;
  PerCourse stiffness_n_per_m;
  PerCourse contact_n_per_m15;  ///< K_b; with 0 there is no contact
  PerCourse load_n;

  /// The force that accelerates the mass: M s", in N.
  [[nodiscard]] PerCourse force_n(const State& state, std::span<const BallContact> balls) const;
};

/// The displacement at which the bearing carries the load at rest, in m.
PerCourse static_equilibrium_m(const EquationOfMotion& equation,
                               std::span<const BallContact> balls);

/// How a signal is sampled: sample i stands for the interval from i / rate to (i + 1) / rate.
struct Sampling {
  double rate_hz = 0;
  std::size_t samples = 0;
};

/// How a sampling interval is divided into the sub-steps of the solution.
struct SubSteps {
  std::size_t count = 0;
  double step_s = 0;
};

/// The solutions of courses_at_once courses side by side.
struct Solution {
  /// [samples], in m/s^2, averaged over each sampling interval. The average is exact, because it is
  /// the change of velocity over the interval. It does what the anti-aliasing filter of an
  /// accelerometer does, and it changes smoothly when a defect moves across the border of two
  /// samples.
  std::vector<PerCourse> acceleration;
  /// How many samples there are before a course diverged; all of them for one that did not.
  Vector<std::int64_t> sane_samples{};
};

/// Solves eq. 13 from `state` at time `start_s` by the classical Runge-Kutta method of order 4 with
/// fixed sub-steps, and leaves the last state in `state`. After a course has diverged, its samples
/// have no meaning.
Solution solve(const EquationOfMotion& equation, LoadedBalls& balls, State& state, double start_s,
               const Sampling& sampling, const SubSteps& sub_steps);

}  // namespace piae::bearing

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "bearing/loaded_balls.hpp"

namespace piae::bearing {

/// Displacement s in m, positive in the direction of the load, and its velocity in m/s.
struct State {
  PerCourse displacement;
  PerCourse velocity;
};

/// Eq. 13 of courses_at_once courses, with its contact term summed over the balls in the load zone:
///     M s" + C s' + K s + K_b sum_j max(s cos(psi_j) - delta_j, 0)^1.5 cos(psi_j) = W.
/// As printed the equation has one ball at a fixed place, which makes a healthy bearing silent.
struct EquationOfMotion {
  PerCourse mass_kg;
  PerCourse damping_ns_per_m;
  PerCourse stiffness_n_per_m;
  PerCourse contact_n_per_m15;  ///< K_b; 0 takes the contact away
  PerCourse load_n;

  /// M s", in N.
  [[nodiscard]] PerCourse force_n(const State& state, std::span<const BallContact> balls) const;
};

/// Where the load is carried at rest, in m.
PerCourse static_equilibrium_m(const EquationOfMotion& equation,
                               std::span<const BallContact> balls);

/// Samples of a signal: sample i stands for the interval [i, i + 1) / rate.
struct Sampling {
  double rate_hz = 0;
  std::size_t samples = 0;
};

/// How a sampling interval is divided into the steps of the solution.
struct SubSteps {
  std::size_t count = 0;
  double step_s = 0;
};

/// Courses side by side.
struct Solution {
  /// [samples], m/s^2, averaged over each sampling interval: an accelerometer with its
  /// anti-aliasing filter sees no less, and the result changes smoothly where a defect moves across
  /// the border of two samples. The average is exact, being the change of velocity over the
  /// interval.
  std::vector<PerCourse> acceleration;
  /// Samples before a course diverged; all of them for one that did not.
  Vector<std::int64_t> sane_samples{};
};

/// Solves eq. 13 from `state` at `start_s` by the classical Runge-Kutta method of order 4 with
/// fixed sub-steps, and leaves the last state in `state`. A course that diverges goes on as numbers
/// without meaning.
Solution solve(const EquationOfMotion& equation, LoadedBalls& balls, State& state, double start_s,
               const Sampling& sampling, const SubSteps& sub_steps);

}  // namespace piae::bearing

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "bearing/defect.hpp"
#include "bearing/equation_of_motion.hpp"
#include "bearing/geometry.hpp"
#include "bearing/hertz.hpp"
#include "bearing/motion.hpp"

namespace piae::bearing {

/// Parameters of eq. 13 besides the bearing and its defect. The paper does not give values. These
/// are the project's choice: the resonance is near 1.8 kHz and the fault frequencies stand out.
struct DynamicsOptions {
  double mass_kg = 1.0;            ///< M
  double stiffness_n_per_m = 1e8;  ///< K
  double damping_ns_per_m = 500;   ///< C
  double clearance_um = 2.0;       ///< gamma of eq. 11
  double load_n = 1000;            ///< W; must exceed K * gamma, or no ball ever carries load
  HertzOptions hertz{};            ///< for K_b of eq. 12
  double settling_s = 0.03;        ///< simulated before the first sample, then discarded
  /// Longest sub-step of the solution. A ball crosses a 7 mil defect of the outer race in 100 us,
  /// so the sub-step must be far shorter. It is shortened further until a whole number of sub-steps
  /// fills a sample. The error is of first order in the sub-step, because delta(t) jumps.
  double max_sub_step_s = 2e-6;
};

/// Returns the largest stiffness at which balls still touch: 2 % below W / clearance.
double largest_stiffness_n_per_m(const DynamicsOptions& options);

/// Divides a sampling interval into the fewest sub-steps that are not longer than `max_sub_step_s`.
/// Throws Error(bad_input) if the rate or the step is not positive and finite.
SubSteps sub_steps(double rate_hz, double max_sub_step_s);

/// One run of a bearing. Courses that are simulated together must have the same settling_s and
/// max_sub_step_s.
struct Course {
  Motion motion;
  DynamicsOptions options;
};

/// Simulates a bearing with the given defect. Returns its accelerations in m/s^2, [courses,
/// samples] row by row, each averaged over its sampling interval (Solution). Each course starts at
/// static equilibrium, a settling time before the first sample. The angles of its motion hold at
/// the first sample.
///
/// Uses one thread and no random numbers. Solving courses_at_once courses takes the time of one, so
/// give each thread that many. The result of a course does not depend on the others, bit for bit.
///
/// Throws Error(bad_input) for values that are impossible or not finite, for a load that does not
/// exceed K * gamma, and for courses that cannot be simulated together. Throws Error(failed) if a
/// course diverges.
std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             std::span<const Course> courses, const Sampling& sampling);

/// Like simulate(), but the defect appears at the first sample. Until then the bearing is healthy;
/// the simulation continues from its state.
std::vector<double> simulate_onset(const Geometry& geometry, const LocalDefect& defect,
                                   std::span<const Course> courses, const Sampling& sampling);

/// simulate() for one course, [samples].
std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             const Motion& motion, const DynamicsOptions& options,
                             const Sampling& sampling);

}  // namespace piae::bearing

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

/// What eq. 13 needs beside the bearing and its defect. The paper gives no values. These are the
/// project's working set, with which the resonance is near 1.8 kHz and the fault frequencies are
/// clear.
struct DynamicsOptions {
  double mass_kg = 1.0;            ///< M
  double stiffness_n_per_m = 1e8;  ///< K
  double damping_ns_per_m = 500;   ///< C
  double clearance_um = 2.0;       ///< gamma of eq. 11
  double load_n = 1000;            ///< W; must exceed K * gamma, or no ball is ever touched
  HertzOptions hertz{};            ///< for K_b of eq. 12
  double settling_s = 0.03;        ///< simulated before the first sample and cut off
  /// The longest sub-step of the solution. A ball crosses a 7 mil defect of the outer race in 100
  /// us, so it must be far shorter than that. It is shortened further until a whole number of
  /// sub-steps makes a sample. The error is of first order in it, because delta(t) jumps.
  double max_sub_step_s = 2e-6;
};

/// The largest stiffness at which there is contact, and so vibration: a little below W / clearance.
double largest_stiffness_n_per_m(const DynamicsOptions& options);

/// Divides a sampling interval into as few sub-steps as are no longer than `max_sub_step_s`. Throws
/// Error(bad_input) for a rate or a step that is not positive and finite.
SubSteps sub_steps(double rate_hz, double max_sub_step_s);

/// One run of a bearing. Courses that are simulated together must have the same settling_s and
/// max_sub_step_s.
struct Course {
  Motion motion;
  DynamicsOptions options;
};

/// Simulates a bearing with the given defect. Returns its accelerations in m/s^2, [courses,
/// samples] row by row, each averaged over its sampling interval (Solution). Each course starts at
/// static equilibrium, a settling time before the first sample; the angles of its motion are those
/// at the first sample.
///
/// This uses one thread and no random numbers. It solves courses_at_once courses in the time of
/// one, so each thread should be given as many. What a course gives does not depend on the others,
/// bit for bit.
///
/// Throws Error(bad_input) for values that are impossible or not finite, for a load that does not
/// exceed K * gamma, and for courses that cannot be simulated together. Throws Error(failed) when a
/// course diverges.
std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             std::span<const Course> courses, const Sampling& sampling);

/// The same where the defect appears at the first sample: until then the bearing is healthy, and
/// goes on from the state in which it then is.
std::vector<double> simulate_onset(const Geometry& geometry, const LocalDefect& defect,
                                   std::span<const Course> courses, const Sampling& sampling);

/// simulate() for one course, [samples].
std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             const Motion& motion, const DynamicsOptions& options,
                             const Sampling& sampling);

}  // namespace piae::bearing

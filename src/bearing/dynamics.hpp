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

/// What eq. 13 needs beside the bearing and its defect. The paper gives no values: these put the
/// resonance near 1.8 kHz and show the fault frequencies clearly (the project's working set).
struct DynamicsOptions {
  double mass_kg = 1.0;            ///< M
  double stiffness_n_per_m = 1e8;  ///< K
  double damping_ns_per_m = 500;   ///< C
  double clearance_um = 2.0;       ///< gamma of eq. 11
  double load_n = 1000;            ///< W; must exceed K * gamma, or no ball is ever touched
  HertzOptions hertz{};            ///< for K_b of eq. 12
  double settling_s = 0.03;        ///< simulated before the first sample and cut off
  /// A 7 mil defect on the outer race is crossed in 100 us, so the step must be far shorter. It is
  /// shortened to an integer number of steps in a sample. delta(t) jumps: the error is first order.
  double max_sub_step_s = 2e-6;
};

/// Up to this stiffness, a little below W / clearance, there is contact, and so vibration.
double largest_stiffness_n_per_m(const DynamicsOptions& options);

/// As few as are no longer than asked. Throws Error(bad_input) for a rate or a step that is not
/// positive and finite.
SubSteps sub_steps(double rate_hz, double max_sub_step_s);

/// One run of a bearing. Runs that are simulated together have settling_s and max_sub_step_s in
/// common.
struct Course {
  Motion motion;
  DynamicsOptions options;
};

/// The accelerations of a bearing with the given defect, in m/s^2, [courses, samples] row by row,
/// averaged over each sampling interval (Solution). Each course starts at static equilibrium, a
/// settling time before the first sample; the angles in its motion hold at the first sample.
///
/// One thread, no random numbers. courses_at_once are solved in the time of one; whoever has many
/// gives each thread so many. What a course gives does not depend on the others, bit for bit.
///
/// Throws Error(bad_input) for values that are impossible or not finite, where the load does not
/// exceed K * gamma, and for courses that do not go together; Error(failed) when one diverges.
std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             std::span<const Course> courses, const Sampling& sampling);

/// Of one course, [samples].
std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             const Motion& motion, const DynamicsOptions& options,
                             const Sampling& sampling);

}  // namespace piae::bearing

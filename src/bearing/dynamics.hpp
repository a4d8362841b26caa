#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "bearing/contacts.hpp"
#include "bearing/defect.hpp"
#include "bearing/geometry.hpp"
#include "bearing/hertz.hpp"

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

/// Displacement s in m, positive in the direction of the load, and its velocity in m/s.
using State = std::array<double, 2>;

/// Eq. 13, with its contact term summed over the balls in the load zone:
///     M s" + C s' + K s + K_b sum_j max(s cos(psi_j) - delta_j, 0)^1.5 cos(psi_j) = W.
/// As printed the equation has one ball at a fixed place, which makes a healthy bearing silent.
struct EquationOfMotion {
  double mass_kg = 0;
  double damping_ns_per_m = 0;
  double stiffness_n_per_m = 0;
  double contact_n_per_m15 = 0;  ///< K_b; 0 takes the contact away
  double load_n = 0;

  [[nodiscard]] double acceleration(const State& state, std::span<const BallContact> balls) const;
};

/// Where the load is carried at rest, in m.
double static_equilibrium_m(const EquationOfMotion& equation, std::span<const BallContact> balls);

/// Samples of a signal: sample i stands for the interval [i, i + 1) / rate.
struct Sampling {
  double rate_hz = 0;
  std::size_t samples = 0;
};

/// Integrates from `state` at `start_s` (classical Runge-Kutta of order 4, fixed sub-steps, by
/// Boost.odeint) and leaves the last state in `state`. Returns the acceleration in m/s^2, averaged
/// over each sampling interval: an accelerometer with its anti-aliasing filter sees no less, and
/// the result changes smoothly where a defect moves across the border of two samples. The average
/// is exact, being the change of velocity over the interval. Throws Error(failed) when the
/// integration diverges.
std::vector<double> integrate(const EquationOfMotion& equation, const BallPassage& passage,
                              State& state, double start_s, const Sampling& sampling,
                              double max_sub_step_s);

/// The acceleration of a bearing with the given defect, in m/s^2, one thread, no random numbers.
/// Starts at static equilibrium, a settling time before the first sample; the angles in `motion`
/// hold at the first sample. Throws Error(bad_input) for values that are impossible or not finite,
/// and where the load does not exceed K * gamma; Error(failed) when the integration diverges.
std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             const Motion& motion, const DynamicsOptions& options,
                             const Sampling& sampling);

}  // namespace piae::bearing

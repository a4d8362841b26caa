#pragma once

#include <vector>

#include "signal/dataset_info.hpp"
#include "signal/window_set.hpp"
#include "twin/contact.hpp"
#include "twin/options.hpp"
#include "twin/space.hpp"

namespace piae::twin {

/// Baselines of eq. 19: k = k~ * 1e8 N/m, c = c~ * 1e2 N s/m.
inline constexpr double stiffness_scale_n_per_m = 1e8;
inline constexpr double damping_scale_ns_per_m = 1e2;

/// Converts a point of the twin space to stiffness and damping in units, and back.
inline signal::DynamicParameters in_units(const TwinPoint& point) {
  return {point.k * stiffness_scale_n_per_m, point.c * damping_scale_ns_per_m};
}
inline TwinPoint without_units(const signal::DynamicParameters& p) {
  return {p.stiffness_n_per_m / stiffness_scale_n_per_m,
          p.damping_ns_per_m / damping_scale_ns_per_m};
}

/// Constants that make the digital twin loss (eq. 22) dimensionless.
///
/// Time is measured in 1/omega_0 with omega_0 = sqrt(1e8 N/m / M), acceleration in a_ref (the RMS
/// of the class's known windows), velocity in a_ref / omega_0 and displacement in a_ref /
/// omega_0^2. Divided by M * a_ref, eq. 22 is
///    a + (c~ * damping) * v + k~ * u + contact(u) = 0
/// where u is the displacement from static equilibrium, because an accelerometer only measures the
/// deviation from it. The load W enters through the equilibrium s_0, which solves k s_0 + F(s_0) =
/// W with the contact force F (contact.hpp). The contact force is relative to that at s_0.
struct Physics {
  double mass_kg = 0;
  double load_n = 0;
  double contact_n_per_m15 = 0;  ///< K_b, eq. 12
  double omega_0 = 0;            ///< rad/s
  double step = 0;               ///< omega_0 / sample rate: dimensionless time between samples
  double damping = 0;            ///< 1e2 N s/m / (M * omega_0)
  std::vector<Contact> contact;  ///< one per class, eq. 11
  std::vector<double> acceleration_m_s2;  ///< a_ref, one per class
};

/// `acceleration` is the RMS of each class's windows in the recordings' unit, info.unit_m_per_s2.
/// `samples` is the length of a window.
Physics make_physics(const signal::DatasetInfo& info, const std::vector<double>& acceleration,
                     std::int64_t samples, const TwinOptions& options);

/// Returns s_0 in metres for a stiffness k: the root of k s + F(s) = W. Newton's method converges
/// to it from above, because the function is convex and increasing there. The stiffness may be 0;
/// then the contact alone carries the load.
double static_equilibrium_m(double stiffness_n_per_m, const Contact& contact,
                            const Physics& physics);

/// True if nothing touches at rest, so that eq. 22 has no Hertz term for small motions.
bool is_open_at_rest(double stiffness_n_per_m, const Contact& contact, const Physics& physics);

}  // namespace piae::twin

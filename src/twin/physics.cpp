#include "twin/physics.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "bearing/defect.hpp"
#include "bearing/hertz.hpp"

namespace piae::twin {

Physics make_physics(const signal::DatasetInfo& info, const std::vector<double>& acceleration,
                     const TwinOptions& options) {
  Physics physics;
  physics.mass_kg = options.mass_kg;
  physics.load_n = options.load_n;
  physics.contact_n_per_m15 = bearing::contact_stiffness(info.bearing);
  physics.omega_0 = std::sqrt(stiffness_scale_n_per_m / options.mass_kg);
  physics.step = physics.omega_0 / info.sample_rate_hz;
  physics.damping = damping_scale_ns_per_m / (options.mass_kg * physics.omega_0);
  for (std::size_t label = 0; label < info.classes.size(); ++label) {
    const signal::ClassInfo& c = info.classes[label];
    const double depth = bearing::defect_depth_m(info.bearing, c.defect_size_mm);
    physics.deflection_m.push_back(options.clearance_um * 1e-6 + depth);
    physics.acceleration_m_s2.push_back(acceleration.at(label) * info.unit_m_per_s2);
  }
  return physics;
}

double static_equilibrium_m(double stiffness_n_per_m, double deflection_m, const Physics& physics) {
  // Neither the spring nor the contact carries more than the load, so s_0 is at most the smaller of
  // the displacements at which one of them alone would carry it. The encoder may infer a stiffness
  // of 0, at which the spring's is infinite.
  const double contact_alone =
      deflection_m + std::pow(physics.load_n / physics.contact_n_per_m15, 2.0 / 3.0);
  double s = std::min(physics.load_n / stiffness_n_per_m, contact_alone);
  for (int i = 0; i < 50; ++i) {
    const double compression = std::max(s - deflection_m, 0.0);
    const double excess = stiffness_n_per_m * s +
                          physics.contact_n_per_m15 * std::pow(compression, 1.5) - physics.load_n;
    const double slope =
        stiffness_n_per_m + 1.5 * physics.contact_n_per_m15 * std::sqrt(compression);
    const double change = excess / slope;
    s -= change;
    if (std::abs(change) <= 1e-15 * s) break;
  }
  return s;
}

}  // namespace piae::twin

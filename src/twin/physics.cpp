#include "twin/physics.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "bearing/hertz.hpp"

namespace piae::twin {

Physics make_physics(const signal::DatasetInfo& info, const std::vector<double>& acceleration,
                     std::int64_t samples, const TwinOptions& options) {
  Physics physics;
  physics.mass_kg = options.mass_kg;
  physics.load_n = options.load_n;
  physics.contact_n_per_m15 = bearing::contact_stiffness(info.bearing);
  physics.omega_0 = std::sqrt(stiffness_scale_n_per_m / options.mass_kg);
  physics.step = physics.omega_0 / info.sample_rate_hz;
  physics.damping = damping_scale_ns_per_m / (options.mass_kg * physics.omega_0);
  for (std::size_t label = 0; label < info.classes.size(); ++label) {
    const signal::ClassInfo& c = info.classes[label];
    physics.contact.push_back(make_contact(info, c, samples, options));
    physics.acceleration_m_s2.push_back(acceleration.at(label) * info.unit_m_per_s2);
  }
  return physics;
}

double static_equilibrium_m(double stiffness_n_per_m, const Contact& contact,
                            const Physics& physics) {
  const double w = contact.at_rest;
  // Neither the spring nor the contact carries more than the load. So s_0 is at most the smaller of
  // the displacements at which one of them alone would carry it. The encoder may infer a stiffness
  // of 0, for which the spring's displacement is infinite.
  const double contact_alone =
      contact.inside_m + std::pow(physics.load_n / physics.contact_n_per_m15, 2.0 / 3.0);
  double s = std::min(physics.load_n / stiffness_n_per_m, contact_alone);
  for (int i = 0; i < 50; ++i) {
    const double outside = std::max(s - contact.outside_m, 0.0);
    const double inside = std::max(s - contact.inside_m, 0.0);
    const double powers = (1 - w) * std::pow(outside, 1.5) + w * std::pow(inside, 1.5);
    const double roots = (1 - w) * std::sqrt(outside) + w * std::sqrt(inside);
    const double excess =
        stiffness_n_per_m * s + physics.contact_n_per_m15 * powers - physics.load_n;
    const double slope = stiffness_n_per_m + 1.5 * physics.contact_n_per_m15 * roots;
    const double change = excess / slope;
    s -= change;
    if (std::abs(change) <= 1e-15 * s) break;
  }
  return s;
}

bool is_open_at_rest(double stiffness_n_per_m, const Contact& contact, const Physics& physics) {
  const double s = static_equilibrium_m(stiffness_n_per_m, contact, physics);
  return contact_force(s - contact.outside_m, s - contact.inside_m, contact.at_rest,
                       physics.contact_n_per_m15)
             .force_n == 0;
}

}  // namespace piae::twin

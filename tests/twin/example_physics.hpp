#pragma once

#include "twin/physics.hpp"

namespace piae::twin {

/// Returns a contact with the same delta throughout.
inline Contact standing_at(double delta_m) { return {.outside_m = 0, .inside_m = delta_m}; }

/// Returns the constants of a 6205 at the working set, with time in units of 1 / omega_0.
inline Physics example_physics() {
  Physics physics;
  physics.mass_kg = 1;
  physics.load_n = 1000;
  physics.contact_n_per_m15 = 8.58e9;
  physics.omega_0 = 1e4;
  physics.step = 1e4 / 12000;
  physics.damping = 0.01;
  physics.contact = {standing_at(2e-6), standing_at(3e-6)};
  physics.acceleration_m_s2 = {3.0, 5.0};
  return physics;
}

}  // namespace piae::twin

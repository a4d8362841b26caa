#include "twin/physics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "twin/example_physics.hpp"

namespace piae::twin {
namespace {

Physics working_set() {
  Physics physics;
  physics.load_n = 1000;
  physics.contact_n_per_m15 = 8.58e9;
  return physics;
}

TEST(StaticEquilibrium, BalancesTheLoad) {
  const Physics physics = working_set();
  for (const double k : {1e6, 1e8, 3.5e8, 1e10}) {
    for (const double delta : {0.0, 2e-6, 1e-5}) {
      const double s = static_equilibrium_m(k, standing_at(delta), physics);
      const double contact = 8.58e9 * std::pow(std::max(s - delta, 0.0), 1.5);
      EXPECT_NEAR(k * s + contact, 1000, 1e-6) << "k " << k << " delta " << delta;
    }
  }
}

TEST(StaticEquilibrium, UsesTheSpringOnlyIfContactIsLost) {
  EXPECT_DOUBLE_EQ(static_equilibrium_m(1e8, standing_at(1.0), working_set()), 1e-5);
}

TEST(StaticEquilibrium, UsesTheContactOnlyWithoutStiffness) {
  const double contact = std::pow(1000 / 8.58e9, 2.0 / 3.0);
  for (const double k : {0.0, 1e-300, 1e-30}) {
    EXPECT_NEAR(static_equilibrium_m(k, standing_at(2e-6), working_set()), 2e-6 + contact, 1e-15)
        << k;
  }
}

TEST(MakePhysics, ScalesTimeAndMotionByEquation19) {
  signal::DatasetInfo info;
  info.sample_rate_hz = 12000;
  info.unit_m_per_s2 = 9.80665;
  info.classes = {{"Normal", signal::Defect::none, 0}, {"IR007", signal::Defect::inner, 0.1778}};
  const Physics physics = make_physics(info, {1.0, 0.3}, 1024, TwinOptions{});
  EXPECT_DOUBLE_EQ(physics.omega_0, 1e4);       // sqrt(1e8 N/m / 1 kg)
  EXPECT_DOUBLE_EQ(physics.step, 1e4 / 12000);  // dimensionless time between samples
  EXPECT_DOUBLE_EQ(physics.damping, 0.01);      // 1e2 / (1 * 1e4)
  EXPECT_NEAR(physics.contact_n_per_m15, 8.58e9, 0.01e9);
  EXPECT_NEAR(physics.contact[0].inside_m, 2e-6, 1e-12);
  EXPECT_NEAR(physics.contact[1].inside_m, 2e-6 + 0.995e-6, 1e-9);  // eq. 10 at 7 mil
  EXPECT_NEAR(physics.acceleration_m_s2[1], 0.3 * 9.80665, 1e-12);
}

}  // namespace
}  // namespace piae::twin

#include "bearing/hertz.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace piae::bearing {
namespace {

TEST(Hertz, CurvaturesOfThe6205MatchTheWorkedExample) {
  // By hand from Harris, eqs 2.28 to 2.31, with f = 0.525 and gamma = 7.94 / 39.
  const Curvature inner = inner_curvature({});
  EXPECT_NEAR(inner.sum_per_m, 328.3, 0.05);
  EXPECT_NEAR(inner.difference, 0.92692, 1e-5);
  const Curvature outer = outer_curvature({});
  EXPECT_NEAR(outer.sum_per_m, 221.3, 0.05);
  EXPECT_NEAR(outer.difference, 0.89159, 1e-5);
}

TEST(Hertz, DeformationOfThe6205MatchesTheWorkedExample) {
  EXPECT_NEAR(contact_deformation(inner_curvature({}).difference), 0.632, 0.0005);
  EXPECT_NEAR(contact_deformation(outer_curvature({}).difference), 0.693, 0.0005);
}

struct Row {
  double difference, deformation;
};

class HarrisTable : public testing::TestWithParam<Row> {};

/// Harris, "Rolling Bearing Analysis", Table 6.1: dimensionless contact parameters.
TEST_P(HarrisTable, IsReproducedByOurHertzContact) {
  EXPECT_NEAR(contact_deformation(GetParam().difference), GetParam().deformation, 3e-4);
}

INSTANTIATE_TEST_SUITE_P(Rows, HarrisTable,
                         testing::Values(Row{0, 1}, Row{0.1075, 0.9974}, Row{0.3204, 0.9761},
                                         Row{0.4795, 0.9429}, Row{0.5916, 0.9077},
                                         Row{0.6716, 0.8733}, Row{0.7332, 0.8394},
                                         Row{0.7948, 0.7961}, Row{0.83495, 0.7602},
                                         Row{0.87366, 0.7169}, Row{0.90999, 0.6636},
                                         Row{0.93657, 0.6112}, Row{0.95738, 0.5551},
                                         Row{0.97290, 0.4960}, Row{0.983797, 0.4352}));

TEST(Hertz, SphereOnPlaneMatchesTheTextbookFormula) {
  // F = (4/3) E* sqrt(R) delta^1.5 with E* = E / (2 (1 - nu^2)), for two bodies of steel.
  const double radius = 0.01;
  const HertzOptions steel;
  const double expected = 4.0 / 3 * steel.youngs_modulus_pa / 2 /
                          (1 - steel.poissons_ratio * steel.poissons_ratio) * std::sqrt(radius);
  EXPECT_NEAR(race_stiffness({2 / radius, 0}) / expected, 1, 1e-6);
}

TEST(Hertz, StiffnessCombinesBothContactsInSeries) {
  EXPECT_NEAR(contact_stiffness({}), 8.58e9, 0.005e9);
  EXPECT_NEAR(contact_stiffness({}, {.groove_ratio = 0.52}), 9.26e9, 0.005e9);
}

TEST(Hertz, SeriesCarriesOneForceThroughTwoDeformations) {
  const double force = 100;
  const double inner = std::pow(force / race_stiffness(inner_curvature({})), 2.0 / 3);
  const double outer = std::pow(force / race_stiffness(outer_curvature({})), 2.0 / 3);
  EXPECT_NEAR(contact_stiffness({}) * std::pow(inner + outer, 1.5), force, 1e-9);
}

TEST(Hertz, RefusesImpossibleMaterialsAndGrooves) {
  EXPECT_THROW(contact_stiffness({}, {.youngs_modulus_pa = 0}), Error);
  EXPECT_THROW(contact_stiffness({}, {.youngs_modulus_pa = std::nan("")}), Error);
  EXPECT_THROW(contact_stiffness({}, {.poissons_ratio = 0.6}), Error);
  EXPECT_THROW(contact_stiffness({}, {.groove_ratio = 0.5}), Error);
  Geometry none;
  none.balls = 0;
  EXPECT_THROW(contact_stiffness(none), Error);
}

}  // namespace
}  // namespace piae::bearing

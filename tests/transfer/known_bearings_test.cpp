#include "transfer/known_bearings.hpp"

#include <gtest/gtest.h>

#include "support/errors.hpp"
#include "transfer/carried.hpp"

namespace piae::transfer {
namespace {

TEST(Kinematics, ScaleWithTheShaftSpeed) {
  const signal::WindowSet known = one_machine();
  const bearing::Geometry& geometry = known.info.bearing;
  // BPFI and BPFO of the geometry, as in every handbook.
  const double ratio = geometry.ball_diameter_mm / geometry.pitch_diameter_mm;
  EXPECT_NEAR(1 / period_s(known, 0, 1200), geometry.balls / 2.0 * 20 * (1 + ratio), 1e-9);
  EXPECT_NEAR(1 / period_s(known, 10, 600), geometry.balls / 2.0 * 10 * (1 - ratio), 1e-9);
  EXPECT_NEAR(passage_s(known, 0, 2, 600), 2 * passage_s(known, 0, 2, 1200), 1e-12);
}

TEST(Kinematics, RefuseAnImpactRateAboveHalfTheSampleRate) {
  signal::WindowSet known = one_machine();
  require_rate(known);
  known.info.sample_rate_hz = 200;
  EXPECT_ERROR(require_rate(known), Exit::bad_input, "class IR5 has");
  known.info.sample_rate_hz = 12000;
  known.info.conditions[1].shaft_speed_rpm = 1e6;
  EXPECT_ERROR(require_rate(known), Exit::bad_input, "at 1e+06 rpm");
}

TEST(Bearings, GroupWindowsByClassConditionAndSize) {
  signal::WindowSet known = one_machine();
  known.condition[3] = 1;
  known.shaft_speed_rpm[3] = 600;
  known.shaft_speed_rpm[4] = 1240;  // another record in the same condition
  known.defect_size_mm.assign(20, 1.0);
  known.defect_size_mm[7] = 0.5;
  const std::vector<KnownBearing> bearings = bearings_of(known);
  ASSERT_EQ(bearings.size(), 6U);
  EXPECT_EQ(bearings[0].windows, (std::vector<std::size_t>{0, 1, 2, 4}));
  EXPECT_EQ(bearings[0].speed_rpm, 1210);
  EXPECT_EQ(bearings[1].windows, (std::vector<std::size_t>{3}));
  EXPECT_EQ(bearings[1].speed_rpm, 600);
  EXPECT_EQ(bearings[2].windows, (std::vector<std::size_t>{7}));
  EXPECT_EQ(bearings[2].size_mm, 0.5);
}

}  // namespace
}  // namespace piae::transfer

#include "transfer/kinematics.hpp"

#include <gtest/gtest.h>

#include "support/errors.hpp"
#include "transfer/carried.hpp"

namespace piae::transfer {
namespace {

TEST(Kinematics, ScaleWithTheSpeedOfTheShaft) {
  const signal::WindowSet known = one_machine();
  const bearing::Geometry& geometry = known.info.bearing;
  // BPFI and BPFO of the geometry, as in every handbook.
  const double ratio = geometry.ball_diameter_mm / geometry.pitch_diameter_mm;
  EXPECT_NEAR(1 / period_s(known, 0, 1200), geometry.balls / 2.0 * 20 * (1 + ratio), 1e-9);
  EXPECT_NEAR(1 / period_s(known, 10, 600), geometry.balls / 2.0 * 10 * (1 - ratio), 1e-9);
  EXPECT_NEAR(passage_s(known, 0, 2, 600), 2 * passage_s(known, 0, 2, 1200), 1e-12);
}

TEST(Kinematics, ARhythmThatWindowsCannotShowIsRefused) {
  signal::WindowSet known = one_machine();
  require_rhythm(known);
  known.info.sample_rate_hz = 200;
  EXPECT_ERROR(require_rhythm(known), Exit::bad_input, "class IR5 is struck");
  known.info.sample_rate_hz = 12000;
  known.info.conditions[1].shaft_speed_rpm = 1e6;
  EXPECT_ERROR(require_rhythm(known), Exit::bad_input, "at 1e+06 rpm");
}

}  // namespace
}  // namespace piae::transfer

#include "bearing/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"

namespace piae::bearing {
namespace {

struct Expected {
  double rpm, bpfo, bpfi, bsf, cage;
};

class Skf6205 : public testing::TestWithParam<Expected> {};

/// Compares with the frequencies that the maker prints.
TEST_P(Skf6205, HasItsFaultFrequencies) {
  const Expected& e = GetParam();
  const FaultFrequencies f = fault_frequencies({}, e.rpm);
  EXPECT_NEAR(f.shaft_hz, e.rpm / 60, 1e-12);
  EXPECT_NEAR(f.bpfo_hz, e.bpfo, 0.005);
  EXPECT_NEAR(f.bpfi_hz, e.bpfi, 0.005);
  EXPECT_NEAR(f.bsf_hz, e.bsf, 0.005);
  EXPECT_NEAR(f.cage_hz, e.cage, 0.0005);
}

INSTANTIATE_TEST_SUITE_P(AtSpeed, Skf6205,
                         testing::Values(Expected{1797, 107.34, 162.21, 70.51, 11.926},
                                         Expected{1500, 89.60, 135.40, 58.85, 9.955}));

TEST(Kinematics, EveryBallPassesOneRaceOrTheOtherOncePerTurn) {
  const FaultFrequencies f = fault_frequencies({}, 1200);
  EXPECT_NEAR(f.bpfo_hz + f.bpfi_hz, 9 * 20.0, 1e-9);
}

TEST(Kinematics, ContactAngleActsByItsCosine) {
  Geometry g;
  g.contact_angle_deg = 60;  // cosine 1/2: like a bearing with balls of half the size
  Geometry half;
  half.ball_diameter_mm /= 2;
  EXPECT_NEAR(speeds(g, 1797).cage, speeds(half, 1797).cage, 1e-9);
  EXPECT_NEAR(speeds(g, 1797).spin, speeds(half, 1797).spin / 2, 1e-9);
}

TEST(Kinematics, SlipReducesCageAndSpinSpeed) {
  const Speeds rolling = speeds({}, 1797);
  const Speeds slipping = speeds({}, 1797, 0.02);
  EXPECT_DOUBLE_EQ(slipping.shaft, rolling.shaft);
  EXPECT_NEAR(slipping.cage, 0.98 * rolling.cage, 1e-12);
  EXPECT_NEAR(slipping.spin, 0.98 * rolling.spin, 1e-12);
}

TEST(Kinematics, SpinningBallRollsWithoutSlipOnTheFixedOuterRace) {
  const Speeds s = speeds({}, 1797);
  // The ball's centre moves at cage speed on the pitch circle; its surface moves backwards against
  // it.
  EXPECT_NEAR(s.cage * 46.94 / 2, (s.spin * 7.94 / 2), 1e-9);
}

TEST(Kinematics, RefusesImpossibleBearings) {
  const auto refused = [](void (*spoil)(Geometry&)) {
    Geometry g;
    spoil(g);
    EXPECT_THROW(validate(g), Error);
  };
  refused([](Geometry& g) { g.balls = 2; });
  refused([](Geometry& g) { g.balls = 16; });  // 16 balls of 7.94 mm need a circle of 40.7 mm
  refused([](Geometry& g) { g.ball_diameter_mm = 0; });
  refused([](Geometry& g) { g.ball_diameter_mm = std::numeric_limits<double>::quiet_NaN(); });
  refused([](Geometry& g) { g.pitch_diameter_mm = std::numeric_limits<double>::infinity(); });
  refused([](Geometry& g) { g.inner_raceway_mm = 40; });
  refused([](Geometry& g) { g.outer_raceway_mm = 38; });
  refused([](Geometry& g) { g.contact_angle_deg = 90; });
  EXPECT_NO_THROW(validate(Geometry{}));
}

}  // namespace
}  // namespace piae::bearing

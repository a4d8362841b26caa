#include "bearing/contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.hpp"

namespace piae::bearing {
namespace {

using std::numbers::pi;

constexpr double clearance_m = 2e-6;
constexpr double depth_m = 8.97e-6;  // 21 mil

std::vector<BallContact> contacts(const LocalDefect& defect, const Motion& motion, double time_s) {
  std::vector<BallContact> contacts;
  BallPassage({}, defect, motion, clearance_m).at(time_s, contacts);
  return contacts;
}

/// How often a loaded ball enters the defect within a second.
int entries(const LocalDefect& defect, const Motion& motion) {
  const BallPassage passage({}, defect, motion, clearance_m);
  std::vector<BallContact> balls;
  int entries = 0;
  bool was_in = false;
  for (int i = 0; i <= 100000; ++i) {
    passage.at(i * 1e-5, balls);
    const bool in = std::ranges::any_of(
        balls, [](const BallContact& ball) { return ball.delta_m > clearance_m; });
    entries += in && !was_in ? 1 : 0;
    was_in = in;
  }
  return entries;
}

TEST(BallPassage, LoadedBallsOfAHealthyBearing) {
  // Nine balls 40 degrees apart, the first 5 degrees ahead of the load: 5, 45, 85, -75 and -35.
  const auto balls = contacts({}, {.shaft_speed_rpm = 1797, .cage_angle_rad = pi / 36}, 0);
  ASSERT_EQ(balls.size(), 5U);
  const std::array<double, 5> degrees{5, 45, 85, -75, -35};
  for (std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_NEAR(balls[i].along, std::cos(degrees[i] * pi / 180), 1e-12);
    EXPECT_EQ(balls[i].delta_m, clearance_m);
  }
}

TEST(BallPassage, BallsMoveWithTheCage) {
  const Motion motion{.shaft_speed_rpm = 1797, .slip = 0.01};
  const double quarter_of_distance_s = 2 * pi / 9 / 4 / speeds({}, 1797, 0.01).cage;
  const auto balls = contacts({}, motion, quarter_of_distance_s);
  EXPECT_NEAR(balls.front().along, std::cos(10 * pi / 180), 1e-12);
}

TEST(BallPassage, BallSinksIntoTheDefectByItsDepth) {
  for (const Defect kind : {Defect::outer, Defect::inner, Defect::roller}) {
    const double angle = kind == Defect::roller ? pi / 2 : 0;
    const auto balls =
        contacts({kind, 0.5334}, {.shaft_speed_rpm = 1797, .defect_angle_rad = angle}, 0);
    EXPECT_NEAR(balls.front().delta_m, clearance_m + depth_m, 5e-9);
    EXPECT_EQ(balls.back().delta_m, clearance_m) << "one ball at a time";
  }
}

TEST(BallPassage, OnlyTheBallThatMeetsTheDefectSinks) {
  // The defect of the outer race sits 40 degrees behind the load, where the ninth ball is.
  const auto balls = contacts({Defect::outer, 0.5334},
                              {.shaft_speed_rpm = 1797, .defect_angle_rad = -40 * pi / 180}, 0);
  for (const BallContact& ball : balls) {
    const bool sinks = ball.delta_m > clearance_m;
    EXPECT_EQ(sinks, &ball == &balls.back());
  }
  EXPECT_NEAR(balls.back().along, std::cos(40 * pi / 180), 1e-12);
}

TEST(BallPassage, CountsOfPassesAreTheFaultFrequencies) {
  const Motion motion{.shaft_speed_rpm = 1797, .cage_angle_rad = 0.3, .defect_angle_rad = 0};
  const FaultFrequencies f = fault_frequencies({}, 1797);
  EXPECT_NEAR(entries({Defect::outer, 0.5334}, motion), f.bpfo_hz, 1);
  // Inner race and ball carry their defect through the loaded half, so half the passes count.
  EXPECT_NEAR(entries({Defect::inner, 0.5334}, motion), f.bpfi_hz / 2, 2);
  EXPECT_NEAR(entries({Defect::roller, 0.5334}, motion), f.bsf_hz, 2);
  EXPECT_EQ(entries({}, motion), 0);
}

TEST(BallPassage, RefusesImpossibleMotion) {
  const auto make = [](const Motion& motion) { BallPassage({}, {}, motion, clearance_m); };
  EXPECT_NO_THROW(make({.shaft_speed_rpm = 1797}));
  EXPECT_THROW(make({.shaft_speed_rpm = 0}), Error);
  EXPECT_THROW(make({.shaft_speed_rpm = -1797}), Error);
  EXPECT_THROW(make({.shaft_speed_rpm = std::nan("")}), Error);
  EXPECT_THROW(make({.shaft_speed_rpm = 1797, .slip = 1}), Error);
  EXPECT_THROW(make({.shaft_speed_rpm = 1797, .slip = -0.1}), Error);
  EXPECT_THROW(make({.shaft_speed_rpm = 1797, .cage_angle_rad = std::nan("")}), Error);
  EXPECT_THROW(make({.shaft_speed_rpm = 1797, .defect_angle_rad = INFINITY}), Error);
}

}  // namespace
}  // namespace piae::bearing

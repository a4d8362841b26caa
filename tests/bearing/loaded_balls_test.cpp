#include "bearing/loaded_balls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "base/error.hpp"

namespace piae::bearing {
namespace {

using std::numbers::pi;

constexpr double clearance_m = 2e-6;
constexpr double depth_m = 8.97e-6;  // 21 mil

LoadedBalls balls_of(const LocalDefect& defect, const Motion& motion) {
  return {{}, defect, std::span(&motion, 1), std::span(&clearance_m, 1)};
}

/// A ball of the first course that can carry load.
struct Ball {
  double along;
  double delta_m;
};

std::vector<Ball> loaded(const LoadedBalls& balls) {
  std::vector<Ball> loaded;
  for (const BallContact& contact : balls.contacts()) {
    if (contact.along[0] > 0) loaded.push_back({contact.along[0], contact.delta_m[0]});
  }
  return loaded;
}

std::vector<Ball> contacts(const LocalDefect& defect, const Motion& motion, double time_s) {
  LoadedBalls balls = balls_of(defect, motion);
  balls.set(time_s);
  return loaded(balls);
}

/// Returns the number of times that a loaded ball enters the defect within a second. Uses rotations
/// of 10 us and resets the positions every 10 ms.
int entries(const LocalDefect& defect, const Motion& motion) {
  LoadedBalls balls = balls_of(defect, motion);
  balls.set_step(1e-5);
  int entries = 0;
  bool was_in = false;
  for (int i = 0; i <= 100000; ++i) {
    i % 1000 == 0 ? balls.set(i * 1e-5) : balls.advance();
    const bool in = std::ranges::any_of(
        loaded(balls), [](const Ball& ball) { return ball.delta_m > clearance_m; });
    entries += in && !was_in ? 1 : 0;
    was_in = in;
  }
  return entries;
}

TEST(LoadedBalls, FaceTheLoadAndDoNotSinkInAHealthyBearing) {
  // Nine balls 40 degrees apart, the first 5 degrees ahead of the load.
  const auto balls = contacts({}, {.shaft_speed_rpm = 1797, .cage_angle_rad = pi / 36}, 0);
  ASSERT_EQ(balls.size(), 5U);
  const std::array<double, 5> degrees{-75, -35, 5, 45, 85};
  for (std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_NEAR(balls[i].along, std::cos(degrees[i] * pi / 180), 1e-12);
    EXPECT_EQ(balls[i].delta_m, clearance_m);
  }
}

TEST(LoadedBalls, MoveWithTheCage) {
  const Motion motion{.shaft_speed_rpm = 1797, .slip = 0.01};
  const double quarter_of_distance_s = 2 * pi / 9 / 4 / speeds({}, 1797, 0.01).cage;
  const auto balls = contacts({}, motion, quarter_of_distance_s);
  EXPECT_NEAR(balls[2].along, std::cos(10 * pi / 180), 1e-12);
}

TEST(LoadedBalls, SinkIntoTheDefectByItsDepth) {
  for (const Defect fault_type : {Defect::outer, Defect::inner, Defect::roller}) {
    const double angle = fault_type == Defect::roller ? pi / 2 : 0;
    const auto balls =
        contacts({fault_type, 0.5334}, {.shaft_speed_rpm = 1797, .defect_angle_rad = angle}, 0);
    ASSERT_EQ(balls.size(), 5U);  // the first ball below the load is the middle one
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_NEAR(balls[i].delta_m, clearance_m + (i == 2 ? depth_m : 0), 5e-9);
    }
  }
}

TEST(LoadedBalls, SinkOnlyAtTheDefect) {
  // The defect of the outer race is 40 degrees behind the load, where the ninth ball is.
  const auto balls = contacts({Defect::outer, 0.5334},
                              {.shaft_speed_rpm = 1797, .defect_angle_rad = -40 * pi / 180}, 0);
  for (const Ball& ball : balls) {
    const bool sinks = ball.delta_m > clearance_m;
    EXPECT_EQ(sinks, &ball == &balls[1]);
  }
  EXPECT_NEAR(balls[1].along, std::cos(40 * pi / 180), 1e-12);
}

TEST(LoadedBalls, PassAtTheFaultFrequencies) {
  const Motion motion{.shaft_speed_rpm = 1797, .cage_angle_rad = 0.3, .defect_angle_rad = 0};
  const FaultFrequencies f = fault_frequencies({}, 1797);
  EXPECT_NEAR(entries({Defect::outer, 0.5334}, motion), f.bpfo_hz, 1);
  // Inner race and ball carry their defect out of the load zone for half a turn, so half of the
  // passes count.
  EXPECT_NEAR(entries({Defect::inner, 0.5334}, motion), f.bpfi_hz / 2, 2);
  EXPECT_NEAR(entries({Defect::roller, 0.5334}, motion), f.bsf_hz, 2);
  EXPECT_EQ(entries({}, motion), 0);
}

/// Balls that enter the load zone within a turn and a half: rotations agree with angles.
TEST(LoadedBalls, RotateByTheSameAngles) {
  for (const int count : {3, 4, 8, 9, 20}) {
    Geometry geometry;
    geometry.balls = count;
    geometry.ball_diameter_mm = 5;
    for (const Defect fault_type : {Defect::outer, Defect::inner, Defect::roller}) {
      const std::array<Motion, 2> motions{
          {{.shaft_speed_rpm = 1797, .slip = 0.01, .cage_angle_rad = 40, .defect_angle_rad = -9},
           {.shaft_speed_rpm = 600, .cage_angle_rad = -3, .defect_angle_rad = 0.1}}};
      const std::array<double, 2> clearances_m{clearance_m, 0};
      LoadedBalls rotated(geometry, {fault_type, 0.5}, motions, clearances_m);
      LoadedBalls set(geometry, {fault_type, 0.5}, motions, clearances_m);
      rotated.set(-0.02);
      rotated.set_step(1e-4);
      for (int i = 1; i < 1000; ++i) {
        rotated.advance();
        set.set(-0.02 + i * 1e-4);
        const auto by_rotation = rotated.contacts();
        const auto by_angle = set.contacts();
        ASSERT_EQ(by_angle.size(), static_cast<std::size_t>((count + 1) / 2));
        for (std::size_t j = 0; j < by_angle.size(); ++j) {
          for (const int lane : {0, 1}) {
            ASSERT_NEAR(by_rotation[j].along[lane], by_angle[j].along[lane], 1e-11);
            ASSERT_EQ(by_rotation[j].delta_m[lane], by_angle[j].delta_m[lane]);
          }
        }
      }
    }
  }
}

TEST(LoadedBalls, EnterAtMostOnePerStep) {
  LoadedBalls balls = balls_of({}, {.shaft_speed_rpm = 1797});
  const double between_balls_s = 1 / fault_frequencies({}, 1797).bpfo_hz;
  EXPECT_NO_THROW(balls.set_step(0.99 * between_balls_s));
  EXPECT_THROW(balls.set_step(1.01 * between_balls_s), Error);
}

TEST(LoadedBalls, RefuseImpossibleMotion) {
  const auto make = [](const Motion& motion) { balls_of({}, motion); };
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

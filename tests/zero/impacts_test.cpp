#include "zero/impacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "impacts/synthesis.hpp"
#include "zero/draws.hpp"
#include "zero/healthy.hpp"

namespace piae::zero {
namespace {

TEST(Impacts, HaveTheLagOfTheSizeByTheSpeedOfTheBall) {
  const signal::WindowSet healthy = healthy_windows();
  const Prior one_size{.least_size_mm = 1, .largest_size_mm = 1};
  // A 6205 at 30 turns a second. The cage passes the outer race of 46.94 mm at (1 - 7.94 / 39) / 2
  // of the shaft speed: pi 46.94 30 0.3982 = 1761.7 mm/s. On the inner race of 31.06 mm: pi 31.06
  // 30 0.6018 = 1761.6 mm/s. A ball of 7.94 mm spins 30 39 / 7.94 / 2 (1 - 0.2036^2) = 70.62 times
  // a second: 1761.6 mm/s. (Balls roll, so all three are equal.)
  for (const auto defect :
       {bearing::Defect::inner, bearing::Defect::outer, bearing::Defect::roller}) {
    const Scene scene = scene_of(healthy, defect);
    double least = 1;
    double most = 0;
    for (int i = 0; i < 400; ++i) {
      Stream random("lag " + std::to_string(i));
      const double lag_s = draw_lag_s(scene, {}, one_size, random);
      least = std::min(least, lag_s);
      most = std::max(most, lag_s);
    }
    EXPECT_NEAR(most, 1 / 1761.6, 0.01 / 1761.6);
    EXPECT_NEAR(least, 0.8 / 1761.6, 0.01 / 1761.6);
  }
}

TEST(Impacts, DefectSizesAreAtMostTheBallRadius) {
  EXPECT_EQ(largest_size_mm({}, {.largest_size_mm = 3.5}), 3.5);
  EXPECT_EQ(largest_size_mm({.ball_diameter_mm = 4}, {.largest_size_mm = 3.5}), 2);
}

TEST(Impacts, HitTheSecondEdgeWithOppositeSign) {
  std::vector<impacts::Impact> impact_times(2000);
  Stream random("exit");
  add_second_edges(0.002, {.least_exit = 0.2}, random, impact_times);
  double sum = 0;
  double squares = 0;
  for (const auto& strike : impact_times) {
    EXPECT_EQ(strike.exit, impact_times[0].exit);
    sum += strike.lag_s;
    squares += strike.lag_s * strike.lag_s;
  }
  EXPECT_GE(impact_times[0].exit, 0.2);
  EXPECT_LE(impact_times[0].exit, 1);
  EXPECT_NEAR(sum / 2000, 0.002, 1e-5);
  EXPECT_NEAR(std::sqrt(squares / 2000 - std::pow(sum / 2000, 2)), 1e-4, 6e-6);
  // The excitation has the sign: 1 - exit exp(-2 pi i f lag), which is 1 - exit at 0 Hz.
  EXPECT_NEAR(impacts::excitation({impact_times[0]}, 2, 100)[0].real(), 1 - impact_times[0].exit,
              1e-12);
}

TEST(Impacts, HaveARoughFloorAsLongAsTheBallIsOnIt) {
  std::vector<impacts::Impact> impact_times{{.time_s = 0.01, .strength = 1}};
  double energies = 0;
  double expected = 0;
  for (int i = 0; i < 300; ++i) {
    const std::string name = "floor " + std::to_string(i);
    Stream random(name);
    const Eigen::ArrayXd floor = draw_rough_floor(impact_times, 0.02, 1024, 12000, random);
    EXPECT_TRUE(floor.head(120).isZero(0));
    EXPECT_TRUE(floor.tail(1024 - 360).isZero(0));
    EXPECT_FALSE(floor.segment(120, 240).isZero(0));
    Stream same(name);
    const double root = 0.14 * std::pow(20, same.uniform(0, 1));
    energies += floor.square().sum();
    expected += root * root;
  }
  EXPECT_NEAR(energies / expected, 1, 0.03);
}

TEST(Impacts, HaveAFloorThatEndsWithTheFrame) {
  Stream random("end");
  const Eigen::ArrayXd floor =
      draw_rough_floor({{.time_s = 0.0845, .strength = 1}}, 0.02, 1024, 12000, random);
  EXPECT_EQ(floor.size(), 1024);
  EXPECT_NE(floor[1023], 0);
}

TEST(Rate, HasItsMeanAtTheOrderOfTheDefectAndStaysWithinTheSlip) {
  const signal::WindowSet healthy = healthy_windows();
  // A 6205 at 30 turns a second: 4.5 (1 + 7.94 / 39) on the inner race, (1 - ...) on the outer
  // race, and 39 / 7.94 (1 - (7.94 / 39)^2) on a ball.
  const double ratio = 7.94 / 39;
  const std::pair<bearing::Defect, double> orders[] = {
      {bearing::Defect::inner, 4.5 * (1 + ratio)},
      {bearing::Defect::outer, 4.5 * (1 - ratio)},
      {bearing::Defect::roller, (1 - ratio * ratio) / ratio}};
  for (const auto& [defect, order] : orders) {
    const Scene scene = scene_of(healthy, defect);
    double sum = 0;
    double widest = 0;
    for (int i = 0; i < 1000; ++i) {
      Stream random("slip " + std::to_string(i));
      const double slip = evenly(random, -0.012, 0.012);
      const double rate = 1 / draw_rate(scene, slip, {}, random).period / 30;
      sum += rate;
      widest = std::max(widest, std::abs(rate / order - 1));
    }
    EXPECT_NEAR(sum / 1000, order, 0.001 * order);
    EXPECT_LE(widest, 0.012 + 1e-12);
    EXPECT_GT(widest, 0.0115);
  }
}

TEST(Rate, IsLessRegularForABall) {
  const signal::WindowSet healthy = healthy_windows();
  for (int i = 0; i < 100; ++i) {
    Stream random("jitter " + std::to_string(i));
    const double race = draw_rate(scene_of(healthy, bearing::Defect::outer), 0, {}, random).jitter;
    EXPECT_GE(race, 0.015 / 7 - 1e-12);
    EXPECT_LE(race, 0.015);
    Stream again("jitter " + std::to_string(i));
    const double ball = draw_rate(scene_of(healthy, bearing::Defect::roller), 0, {}, again).jitter;
    EXPECT_NEAR(ball, 2 * race, 1e-12);
  }
}

TEST(LoadOfADefect, IsDrawnWithinThePrior) {
  const bearing::Speeds speeds = bearing::speeds({}, 1800);
  Prior prior;
  prior.load.rotating = 0.5;
  const auto widest = [&](bearing::Defect defect) {
    double angle_rad = 0;
    for (int i = 0; i < 300; ++i) {
      Stream random("load " + std::to_string(i));
      const impacts::Load load = draw_load(defect, speeds, prior, random);
      EXPECT_GE(load.extent, 0.3);
      EXPECT_LE(load.extent, 1.5);
      EXPECT_LE(load.rotating, defect == bearing::Defect::inner ? 0 : 0.5);
      angle_rad = std::max(angle_rad, std::abs(load.angle_rad));
    }
    return angle_rad;
  };
  EXPECT_LE(widest(bearing::Defect::outer), 0.6);
  EXPECT_GT(widest(bearing::Defect::outer), 0.58);
  EXPECT_GT(widest(bearing::Defect::inner), 3.1);
  Stream random("none");
  EXPECT_EQ(draw_load(bearing::Defect::inner, speeds, {.load_zone = Switch::off}, random).extent,
            0);
}

}  // namespace
}  // namespace piae::zero

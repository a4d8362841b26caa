#include "zero/impacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "zero/healthy.hpp"

namespace piae::zero {
namespace {

TEST(Impacts, HaveTheLagOfTheSizeByTheSpeedOfTheBall) {
  const signal::WindowSet healthy = healthy_windows();
  const Prior one_size{.least_size_mm = 1, .largest_size_mm = 1};
  // A 6205 at 30 turns a second. On a race of 46.94 mm, which the cage passes with
  // (1 - 7.94 / 39) / 2 of that: pi 46.94 30 0.3982 = 1761.7 mm/s. On the inner one of 31.06 mm:
  // pi 31.06 30 0.6018 = 1761.6 mm/s. A ball of 7.94 mm spins 30 39 / 7.94 / 2 (1 - 0.2036^2) =
  // 70.62 times: 1761.6 mm/s. (It rolls, so all three are the same.)
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

TEST(Impacts, AreOfDefectsThatABallDoesNotRollOutOf) {
  EXPECT_EQ(largest_size_mm({}, {.largest_size_mm = 3.5}), 3.5);
  EXPECT_EQ(largest_size_mm({.ball_diameter_mm = 4}, {.largest_size_mm = 3.5}), 2);
}

TEST(Impacts, StrikeTheSecondEdgeTheOtherWay) {
  std::vector<transfer::Strike> strikes(2000);
  Stream random("exit");
  add_second_edges(0.002, {.least_exit = 0.2}, random, strikes);
  double sum = 0;
  double squares = 0;
  for (const auto& strike : strikes) {
    EXPECT_EQ(strike.exit, strikes[0].exit);
    sum += strike.lag_s;
    squares += strike.lag_s * strike.lag_s;
  }
  EXPECT_GE(strikes[0].exit, 0.2);
  EXPECT_LE(strikes[0].exit, 1);
  EXPECT_NEAR(sum / 2000, 0.002, 1e-5);
  EXPECT_NEAR(std::sqrt(squares / 2000 - std::pow(sum / 2000, 2)), 1e-4, 6e-6);
  // Excitation takes the sign: 1 - exit exp(-2 pi i f lag), which is 1 - exit at 0 Hz.
  EXPECT_NEAR(transfer::excitation({strikes[0]}, 2, 100)[0].real(), 1 - strikes[0].exit, 1e-12);
}

TEST(Impacts, HaveARoughFloorAsLongAsTheBallIsOnIt) {
  std::vector<transfer::Strike> strikes{{.time_s = 0.01, .strength = 1}};
  double energies = 0;
  double expected = 0;
  for (int i = 0; i < 300; ++i) {
    const std::string name = "floor " + std::to_string(i);
    Stream random(name);
    const Eigen::ArrayXd floor = draw_rough_floor(strikes, 0.02, 1024, 12000, random);
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

}  // namespace
}  // namespace piae::zero

#include "zero/background.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "zero/healthy.hpp"

namespace piae::zero {
namespace {

TEST(Background, IsTheHealthyWindowOrItsReversal) {
  const signal::WindowSet healthy = healthy_windows(64, 1);
  const auto window = healthy.window(0);
  const double deviation = deviation_of(window);
  double mean = 0;
  for (const float x : window) mean += x / 64;
  int backwards = 0;
  for (int i = 0; i < 200; ++i) {
    Stream random("turn " + std::to_string(i));
    const Eigen::ArrayXd made = draw_background(window, 0, random);
    const bool turned = std::abs(made[0] - (window[0] - mean) / deviation) > 1e-5;
    backwards += turned ? 1 : 0;
    for (std::size_t t = 0; t < 64; ++t) {
      const std::size_t from = turned ? 63 - t : t;
      ASSERT_NEAR(made[static_cast<Eigen::Index>(t)], (window[from] - mean) / deviation, 1e-5);
    }
  }
  EXPECT_NEAR(backwards, 100, 30);  // four standard deviations of 7
}

TEST(Background, HasUnitMeanSquareAlsoThroughAPath) {
  const signal::WindowSet healthy = healthy_windows();
  Stream random("path");
  const Eigen::ArrayXd made = draw_background(healthy.window(3), 6, random);
  EXPECT_NEAR(made.square().mean(), 1, 1e-9);
  Stream again("path");
  EXPECT_GT((made - draw_background(healthy.window(3), 0, again)).square().mean(), 0.01);
}

TEST(Background, GivesAWindowItsLevel) {
  const signal::WindowSet healthy = healthy_windows();
  const Eigen::ArrayXd ramp = Eigen::ArrayXd::LinSpaced(1024, 3, 700);
  const std::vector<float> made = at_level_of(healthy.window(4), ramp);
  EXPECT_NEAR(deviation_of(made), deviation_of(healthy.window(4)), 1e-4);
  for (const float x : at_level_of(healthy.window(4), Eigen::ArrayXd::Zero(1024))) EXPECT_EQ(x, 0);
}

TEST(Background, ModulatesAtTheRatesOfTheBearing) {
  const signal::WindowSet healthy = healthy_windows();
  const Scene scene = scene_of(healthy, bearing::Defect::outer);
  Prior exact;
  exact.slip = 0;
  constexpr std::size_t samples = 12000;  // a second
  int present_at_shaft = 0;
  for (int i = 0; i < 200; ++i) {
    Stream random("modulation " + std::to_string(i));
    const Eigen::ArrayXd factor = draw_modulation(scene, {}, samples, 12000, exact, random);
    EXPECT_GE(factor.minCoeff(), 0);
    std::complex<double> at_shaft = 0;
    for (std::size_t t = 0; t < samples; ++t) {
      at_shaft += factor[static_cast<Eigen::Index>(t)] *
                  std::polar(1.0, -2 * std::numbers::pi * 30 * static_cast<double>(t) / 12000);
    }
    const double depth = 2 * std::abs(at_shaft) / samples;
    EXPECT_LT(depth, 0.31);
    present_at_shaft += depth > 0.025 ? 1 : 0;
  }
  EXPECT_NEAR(present_at_shaft, 140, 26);  // 0.7 of 200, four standard deviations of 6.5
}

TEST(Background, ModulatesNothingWithDepthZero) {
  const signal::WindowSet healthy = healthy_windows();
  Stream random("none");
  const Eigen::ArrayXd factor = draw_modulation(scene_of(healthy, bearing::Defect::inner), {}, 64,
                                                12000, {.modulation = 0}, random);
  EXPECT_TRUE(factor.isOnes(0));
}

TEST(Background, HasThreeStrayImpactsOnAverageAtTheirProbability) {
  int windows = 0;
  double impacts = 0;
  double up = 0;
  for (int i = 0; i < 3000; ++i) {
    Stream random("knocks " + std::to_string(i));
    const auto drawn = draw_stray_impacts(2, {.stray_impacts = 0.3}, random);
    windows += drawn.empty() ? 0 : 1;
    impacts += static_cast<double>(drawn.size());
    for (const auto& impact : drawn) {
      up += impact.strength > 0 ? 1 : 0;
      EXPECT_GE(impact.time_s, 0);
      EXPECT_LT(impact.time_s, 2);
    }
  }
  EXPECT_NEAR(windows, 900, 100);
  EXPECT_NEAR(impacts / windows, 3, 0.2);
  EXPECT_NEAR(up / impacts, 0.5, 0.04);
}

}  // namespace
}  // namespace piae::zero

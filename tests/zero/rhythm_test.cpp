#include "zero/rhythm.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "zero/healthy.hpp"

namespace piae::zero {
namespace {

TEST(Rhythm, HasItsMeanAtTheOrderOfTheDefectAndStaysWithinTheSlip) {
  const signal::WindowSet healthy = healthy_windows();
  // A 6205 at 30 turns a second: 4.5 (1 + 7.94 / 39) on the inner race, (1 - ...) on the outer one,
  // and 39 / 7.94 (1 - (7.94 / 39)^2) on a ball.
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
      const double rate = 1 / draw_rhythm(scene, {}, random).period_s / 30;
      sum += rate;
      widest = std::max(widest, std::abs(rate / order - 1));
    }
    EXPECT_NEAR(sum / 1000, order, 0.001 * order);
    EXPECT_LE(widest, 0.012 + 1e-12);
    EXPECT_GT(widest, 0.0115);
  }
}

TEST(Rhythm, OfABallIsLessRegular) {
  const signal::WindowSet healthy = healthy_windows();
  for (int i = 0; i < 100; ++i) {
    Stream random("jitter " + std::to_string(i));
    const double race = draw_rhythm(scene_of(healthy, bearing::Defect::outer), {}, random).jitter;
    EXPECT_GE(race, 0.015 / 7 - 1e-12);
    EXPECT_LE(race, 0.015);
    Stream again("jitter " + std::to_string(i));
    const Rhythm ball = draw_rhythm(scene_of(healthy, bearing::Defect::roller), {}, again);
    EXPECT_NEAR(ball.jitter, 2 * race, 1e-12);
  }
}

TEST(Rhythm, StrikesAtItsMeanRateWithDeviationsThatAddUp) {
  const Rhythm rhythm{.period_s = 0.01, .slip = 0, .jitter = 0.02};
  Stream random("strikes");
  const auto strikes = regular_strikes(rhythm, 100, random);
  // 10^4 periods, whose sum has a standard deviation of 0.02 sqrt(10^4) = 2 of them.
  EXPECT_NEAR(static_cast<double>(strikes.size()), 10000, 8);
  double squares = 0;
  for (std::size_t i = 1; i < strikes.size(); ++i) {
    squares += std::pow((strikes[i].time_s - strikes[i - 1].time_s) / 0.01 - 1, 2);
  }
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(strikes.size() - 1)), 0.02, 0.0006);
  EXPECT_LT(strikes.front().time_s, 0.01);
}

}  // namespace
}  // namespace piae::zero

#include "transfer/strike_train.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace piae::transfer {
namespace {

const Rhythm even{
    .period_s = 0.01, .jitter = 0, .edges = {.lag_s = 0.002, .exit = 0.5, .spread = 0}};

TEST(StrikeTrain, WithoutJitterStrikesOncePerPeriodToTheEndOfTheFrame) {
  Stream random("even");
  const std::vector<Strike> strikes =
      draw_strikes(random, even, std::vector<double>(most_strikes(even, 0.2), 1.0), 0.2);
  EXPECT_GE(strikes.front().time_s, 0);
  EXPECT_LT(strikes.front().time_s, 0.01);
  EXPECT_EQ(strikes.size(), 20U);
  for (std::size_t i = 0; i < strikes.size(); ++i) {
    EXPECT_NEAR(strikes[i].time_s, strikes[0].time_s + 0.01 * static_cast<double>(i), 1e-12);
    EXPECT_EQ(strikes[i].lag_s, 0.002);
    EXPECT_EQ(strikes[i].exit, 0.5);
  }
}

TEST(StrikeTrain, StrikesHaveTheStrengthsInTheirOrder) {
  Stream random("strengths");
  std::vector<double> strengths(most_strikes(even, 0.2));
  std::iota(strengths.begin(), strengths.end(), 1.0);
  const std::vector<Strike> strikes = draw_strikes(random, even, strengths, 0.2);
  ASSERT_EQ(strikes.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(strikes[i].strength, 1.0 + static_cast<double>(i));
}

TEST(StrikeTrain, TimesLieWithinTheWindowInSeconds) {
  const std::vector<double> strikes{-0.5, 0, 512, std::nextafter(1024.0, 0.0), 1024, 1030};
  const std::vector<double> times_s = times_within(strikes, 1024, 12000);
  // The fourth is a strike within the window, and its time is the end of it.
  ASSERT_EQ(strikes[3] / 12000, 1024 / 12000.0);
  ASSERT_EQ(times_s.size(), 2U);
  EXPECT_EQ(times_s[0], 0);
  EXPECT_EQ(times_s[1], 512 / 12000.0);
}

TEST(StrikeTrain, LagsAndStepsSpreadAsTheyShould) {
  Stream random("spread");
  const Rhythm rhythm{
      .period_s = 0.01, .jitter = 0.02, .edges = {.lag_s = 0.002, .exit = 0.5, .spread = 0.05}};
  const std::vector<Strike> strikes =
      draw_strikes(random, rhythm, std::vector<double>(most_strikes(rhythm, 40), 1.0), 40);
  double steps = 0;
  double lags = 0;
  for (std::size_t i = 1; i < strikes.size(); ++i) {
    steps += std::pow((strikes[i].time_s - strikes[i - 1].time_s) / 0.01 - 1, 2);
    lags += std::pow(strikes[i].lag_s / 0.002 - 1, 2);
  }
  // Standard deviations of some 4000, to within 4 / sqrt(2 * 4000) of themselves.
  const auto count = static_cast<double>(strikes.size() - 1);
  EXPECT_NEAR(std::sqrt(steps / count), 0.02, 0.02 * 0.045);
  EXPECT_NEAR(std::sqrt(lags / count), 0.05, 0.05 * 0.045);
}

}  // namespace
}  // namespace piae::transfer

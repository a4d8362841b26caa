#include "impacts/times.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace piae::impacts {
namespace {

TEST(Times, WithoutJitterComeOncePerPeriod) {
  Stream random("even");
  const ImpactRate even{.period = 0.01, .jitter = 0};
  const std::vector<Impact> impacts = draw_impacts(random, even, 0.2, [](std::size_t i) {
    return Impact{.strength = 1.0 + static_cast<double>(i), .lag_s = 0.002};
  });
  EXPECT_GE(impacts.front().time_s, 0);
  EXPECT_LT(impacts.front().time_s, 0.01);
  ASSERT_EQ(impacts.size(), 20U);
  EXPECT_GE(most_impacts(even, 0.2), 20U);
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    EXPECT_NEAR(impacts[i].time_s, impacts[0].time_s + 0.01 * static_cast<double>(i), 1e-12);
    EXPECT_EQ(impacts[i].strength, 1.0 + static_cast<double>(i));
    EXPECT_EQ(impacts[i].lag_s, 0.002);
  }
}

TEST(Times, AreWithinTheWindowInSeconds) {
  const std::vector<double> samples{-0.5, 0, 512, std::nextafter(1024.0, 0.0), 1024, 1030};
  const std::vector<double> times_s = times_within(samples, 1024, 12000);
  // The fourth position is within the window, but its time rounds to the end.
  ASSERT_EQ(samples[3] / 12000, 1024 / 12000.0);
  ASSERT_EQ(times_s.size(), 2U);
  EXPECT_EQ(times_s[0], 0);
  EXPECT_EQ(times_s[1], 512 / 12000.0);
}

TEST(Times, HaveTheMeanRateAndDeviationsThatAddUp) {
  Stream random("impacts");
  const auto impacts = draw_impacts(random, {.period = 0.01, .jitter = 0.02}, 100);
  // 10^4 periods; the standard deviation of their sum is 0.02 sqrt(10^4) = 2 periods.
  EXPECT_NEAR(static_cast<double>(impacts.size()), 10000, 8);
  double squares = 0;
  for (std::size_t i = 1; i < impacts.size(); ++i) {
    squares += std::pow((impacts[i].time_s - impacts[i - 1].time_s) / 0.01 - 1, 2);
    EXPECT_EQ(impacts[i].strength, 1);
  }
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(impacts.size() - 1)), 0.02, 0.0006);
}

}  // namespace
}  // namespace piae::impacts

#include "transfer/turning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace piae::transfer {
namespace {

/// Returns decaying pulses, the first at `first`.
std::vector<double> pulses(double first, double period, double height, std::size_t length) {
  std::vector<double> window(length);
  for (std::size_t i = 0; i < length; ++i) {
    const double since = std::fmod(static_cast<double>(i) - first + 100 * period, period);
    window[i] = height * std::exp(-since / 4);
  }
  return window;
}

TEST(Turning, BeginsAtAStrikeAndHoldsWholeOnes) {
  const std::vector<double> window = pulses(17, 50, 1, 256);
  const Turning turning = turning_of(window, {.first = 17, .period = 50});
  EXPECT_EQ(turning.cycle.strikes, 4U);
  EXPECT_EQ(turning.cycle.samples, 200U);
  for (std::size_t i = 0; i < 200; ++i) EXPECT_NEAR(turning.samples[i], window[17 + i % 50], 1e-9);
}

TEST(Turned, GoesOnInTheSecondInTheSameRhythm) {
  const Turning low = turning_of(pulses(17, 50, 1, 256), {.first = 17, .period = 50});
  const Turning high = turning_of(pulses(40, 50, 9, 256), {.first = 40, .period = 50});
  bool both = false;
  for (int i = 0; i < 20; ++i) {
    Stream random("turned " + std::to_string(i));
    const StruckWindow window = turned(low, high, 256, random);
    ASSERT_EQ(window.samples.size(), 256U);
    ASSERT_GE(window.strikes.size(), 5U);
    for (std::size_t j = 1; j < window.strikes.size(); ++j) {
      EXPECT_NEAR(window.strikes[j] - window.strikes[j - 1], 50, 1e-9);
    }
    double before = 0;  // heights at the impacts
    for (const double strike : window.strikes) {
      const double height = window.samples[static_cast<std::size_t>(strike)];
      EXPECT_TRUE(std::abs(height - 1) < 1e-4 || std::abs(height - 9) < 1e-3) << height;
      EXPECT_GE(height, before - 1e-3);  // once in the second window, it stays there
      before = height;
    }
    both = both ||
           (window.samples[static_cast<std::size_t>(window.strikes.front())] < 2 && before > 8);
  }
  EXPECT_TRUE(both);
}

TEST(Turned, IsStruckInRhythmWhereThePeriodIsNoWholeNumber) {
  const std::vector<double> silence(256, 0.0);
  const Turning first = turning_of(silence, {.first = 1, .period = 7.0 / 3});
  const Turning second = turning_of(silence, {.first = 0, .period = 7.25 / 3});
  for (int i = 0; i < 200; ++i) {
    Stream random("rhythm " + std::to_string(i));
    const std::vector<double> strikes = turned(first, second, 256, random).strikes;
    for (std::size_t j = 1; j < strikes.size(); ++j) {
      ASSERT_GE(strikes[j] - strikes[j - 1], first.cycle.period() - 1e-9) << i;
      ASSERT_LE(strikes[j] - strikes[j - 1], second.cycle.period() + 1e-9) << i;
    }
    ASSERT_LT(strikes.front(), 7.25 / 3);
    ASSERT_GT(strikes.back(), 256 - 7.5 / 3);
  }
}

// A sensor that starts late still gives a cycle.
TEST(Turning, IsOfTheLoudestStretch) {
  std::vector<double> window = pulses(10, 120, 1, 256);
  std::fill(window.begin(), window.begin() + 124, 0.0);
  const Turning turning = turning_of(window, {.first = 10, .period = 120});
  EXPECT_EQ(turning.cycle.samples, 240U);
  const Turning one = turning_of(std::vector<double>(window.begin(), window.begin() + 200),
                                 {.first = 10, .period = 120});
  ASSERT_EQ(one.cycle.samples, 120U);
  EXPECT_NEAR(one.samples[0], window[130], 1e-9);
  EXPECT_GT(*std::ranges::max_element(one.samples), 0.99);
}

TEST(Turned, TurnsAWindowWithoutAWholeStrikeRound) {
  std::vector<double> window(64);
  for (std::size_t i = 0; i < 64; ++i) window[i] = static_cast<double>(i);
  const Turning turning = turning_of(window, {.first = 20, .period = 100});
  Stream random("long");
  const StruckWindow turned_round = turned(turning, turning, 64, random);
  EXPECT_TRUE(turned_round.strikes.empty());  // nothing is known about them
  for (std::size_t i = 1; i < 64; ++i) {
    const double step = turned_round.samples[i] - turned_round.samples[i - 1];
    EXPECT_TRUE(step == 1 || step == -63) << step;
  }
}

}  // namespace
}  // namespace piae::transfer

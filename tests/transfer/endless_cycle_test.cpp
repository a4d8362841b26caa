#include "transfer/endless_cycle.hpp"

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

TEST(EndlessCycle, StartsAtAnImpactAndHoldsWholePeriods) {
  const std::vector<double> window = pulses(17, 50, 1, 256);
  const EndlessCycle endless = endless_cycle_of(window, {.first = 17, .period = 50});
  EXPECT_EQ(endless.cycle.impacts, 4U);
  EXPECT_EQ(endless.cycle.samples, 200U);
  for (std::size_t i = 0; i < 200; ++i) EXPECT_NEAR(endless.samples[i], window[17 + i % 50], 1e-9);
}

TEST(RotatedWindows, ContinuesInTheSecondWindowAtTheSameRate) {
  const EndlessCycle low = endless_cycle_of(pulses(17, 50, 1, 256), {.first = 17, .period = 50});
  const EndlessCycle high = endless_cycle_of(pulses(40, 50, 9, 256), {.first = 40, .period = 50});
  bool both = false;
  for (int i = 0; i < 20; ++i) {
    Stream random("turned " + std::to_string(i));
    const ImpactWindow window = window_of_cycles(low, high, 256, random);
    ASSERT_EQ(window.samples.size(), 256U);
    ASSERT_GE(window.impact_positions.size(), 5U);
    for (std::size_t j = 1; j < window.impact_positions.size(); ++j) {
      EXPECT_NEAR(window.impact_positions[j] - window.impact_positions[j - 1], 50, 1e-9);
    }
    double before = 0;  // heights at the impacts
    for (const double strike : window.impact_positions) {
      const double height = window.samples[static_cast<std::size_t>(strike)];
      EXPECT_TRUE(std::abs(height - 1) < 1e-4 || std::abs(height - 9) < 1e-3) << height;
      EXPECT_GE(height, before - 1e-3);  // once in the second window, it stays there
      before = height;
    }
    both = both || (window.samples[static_cast<std::size_t>(window.impact_positions.front())] < 2 &&
                    before > 8);
  }
  EXPECT_TRUE(both);
}

TEST(RotatedWindows, KeepsAPeriodOfFractionalSamples) {
  const std::vector<double> silence(256, 0.0);
  const EndlessCycle first = endless_cycle_of(silence, {.first = 1, .period = 7.0 / 3});
  const EndlessCycle second = endless_cycle_of(silence, {.first = 0, .period = 7.25 / 3});
  for (int i = 0; i < 200; ++i) {
    Stream random("rhythm " + std::to_string(i));
    const std::vector<double> impact_positions =
        window_of_cycles(first, second, 256, random).impact_positions;
    for (std::size_t j = 1; j < impact_positions.size(); ++j) {
      ASSERT_GE(impact_positions[j] - impact_positions[j - 1], first.cycle.period() - 1e-9) << i;
      ASSERT_LE(impact_positions[j] - impact_positions[j - 1], second.cycle.period() + 1e-9) << i;
    }
    ASSERT_LT(impact_positions.front(), 7.25 / 3);
    ASSERT_GT(impact_positions.back(), 256 - 7.5 / 3);
  }
}

// A sensor that starts late still gives a cycle.
TEST(EndlessCycle, UsesTheStretchOfHighestRms) {
  std::vector<double> window = pulses(10, 120, 1, 256);
  std::fill(window.begin(), window.begin() + 124, 0.0);
  const EndlessCycle endless = endless_cycle_of(window, {.first = 10, .period = 120});
  EXPECT_EQ(endless.cycle.samples, 240U);
  const EndlessCycle one = endless_cycle_of(
      std::vector<double>(window.begin(), window.begin() + 200), {.first = 10, .period = 120});
  ASSERT_EQ(one.cycle.samples, 120U);
  EXPECT_NEAR(one.samples[0], window[130], 1e-9);
  EXPECT_GT(*std::ranges::max_element(one.samples), 0.99);
}

TEST(RotatedWindows, ShiftsAWindowWithoutAWholePeriodCircularly) {
  std::vector<double> window(64);
  for (std::size_t i = 0; i < 64; ++i) window[i] = static_cast<double>(i);
  const EndlessCycle endless = endless_cycle_of(window, {.first = 20, .period = 100});
  Stream random("long");
  const ImpactWindow circularly_shifted = window_of_cycles(endless, endless, 64, random);
  EXPECT_TRUE(circularly_shifted.impact_positions.empty());  // nothing is known about them
  for (std::size_t i = 1; i < 64; ++i) {
    const double step = circularly_shifted.samples[i] - circularly_shifted.samples[i - 1];
    EXPECT_TRUE(step == 1 || step == -63) << step;
  }
}

}  // namespace
}  // namespace piae::transfer

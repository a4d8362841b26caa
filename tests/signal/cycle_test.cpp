#include "signal/cycle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.hpp"

namespace piae::signal {
namespace {

// An impact every 12000 / 107.34 = 111.79 samples: 8 in 894.4; 9 would leave only 18 of 1024.
TEST(Cycle, HoldsTheMostWholePeriodsThatLeaveSamplesToBlend) {
  const Cycle cycle = *cycle_of(12000 / 107.34, 1024);
  EXPECT_EQ(cycle.impacts, 8U);
  EXPECT_EQ(cycle.samples, 894U);
  EXPECT_EQ(cycle.offset_of_impact(0), 0U);
  EXPECT_EQ(cycle.offset_of_impact(1), 112U);
  EXPECT_EQ(cycle.offset_of_impact(4), 447U);
  EXPECT_EQ(cycle.period(), 111.75);
  EXPECT_NEAR(cycle.angle_rad(447), 0, 1e-12);
  EXPECT_NEAR(cycle.angle_rad(1), 2 * std::numbers::pi * 8 / 894, 1e-12);
}

TEST(Cycle, IsEmptyIfNoWholePeriodFits) {
  EXPECT_FALSE(cycle_of(111.8, 100));
  EXPECT_FALSE(cycle_of(99, 100));  // leaves too little to blend
  EXPECT_TRUE(cycle_of(96, 100));
}

TEST(ClosedCycle, KeepsAPeriodicSignal) {
  const Cycle cycle{90, 3, 16};
  std::vector<double> window(128);
  for (std::size_t i = 0; i < window.size(); ++i) {
    window[i] = std::sin(2 * std::numbers::pi * static_cast<double>(i) / 30);
  }
  const std::vector<double> waveform = closed_cycle(window, cycle);
  ASSERT_EQ(waveform.size(), 90U);
  for (std::size_t i = 0; i < 90; ++i) EXPECT_NEAR(waveform[i], window[i], 1e-12);
}

// A ramp jumps by its whole height at a plain cut. After blending, each step is at most that of the
// blend, height / 16, plus the ramp's own.
TEST(ClosedCycle, BlendsTheEndIntoTheStart) {
  const Cycle cycle{90, 3, 16};
  std::vector<double> window(128);
  for (std::size_t i = 0; i < window.size(); ++i) window[i] = static_cast<double>(i);
  const std::vector<double> waveform = closed_cycle(window, cycle);
  for (std::size_t i = 0; i < 90; ++i) {
    EXPECT_LE(std::abs(waveform[(i + 1) % 90] - waveform[i]), 90.0 / 16 + 1) << i;
  }
}

// The twin relies on this: another start angle gives the same waveform, shifted.
TEST(Read, ShiftsTheWaveformBitForBit) {
  Stream stream("waveform");
  std::vector<float> waveform(97);
  for (float& x : waveform) x = static_cast<float>(stream.normal(0, 1));
  const std::vector<float> window = read(std::span<const float>(waveform), 5, 300);
  for (const std::size_t shift : {1U, 40U, 96U}) {
    const std::vector<float> shifted = read(std::span<const float>(waveform), 5 + shift, 300);
    for (std::size_t i = 0; i + shift < 300; ++i) ASSERT_EQ(shifted[i], window[i + shift]);
  }
}

}  // namespace
}  // namespace piae::signal

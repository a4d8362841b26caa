#include "monitor/sample_clock.hpp"

#include <gtest/gtest.h>

namespace piae::monitor {
namespace {

TEST(SampleClock, TellsByHowMuchSamplesAreLate) {
  SampleClock clock(100, 1);
  EXPECT_EQ(clock.late_by(50, 100), 0);  // whatever the clock shows at the beginning
  EXPECT_EQ(clock.late_by(51, 200), 0);
  EXPECT_EQ(clock.late_by(52.9, 300), 0);  // 0.9 s late, which may be
  EXPECT_NEAR(clock.late_by(56, 300), 4, 0.01);
  EXPECT_EQ(clock.late_by(57, 400), 0);  // on time again, as things are now
  EXPECT_NEAR(clock.late_by(59, 450), 1.5, 0.01);
  EXPECT_EQ(clock.times(), 2U);
  EXPECT_NEAR(clock.all_s(), 5.5, 0.01);
}

TEST(SampleClock, WhatCatchesUpIsMeasuredAnew) {
  SampleClock clock(100, 1);
  clock.late_by(0, 0);
  EXPECT_NEAR(clock.late_by(5, 0), 5, 0.01);
  EXPECT_EQ(clock.late_by(5.1, 510), 0);  // all at once
  EXPECT_NEAR(clock.late_by(8, 600), 2, 0.01);
}

/// A day in which the recorder's clock is slow by 100 millionths: 8.6 s.
TEST(SampleClock, ClocksMayRunApart) {
  SampleClock clock(1000 * (1 - 100e-6), 1);
  for (int s = 0; s <= 86400; ++s) {
    const auto samples = static_cast<std::uint64_t>(1000.0 * s * (1 - 200e-6));
    ASSERT_EQ(clock.late_by(s, samples), 0) << s;
  }
}

}  // namespace
}  // namespace piae::monitor

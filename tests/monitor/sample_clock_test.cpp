#include "monitor/sample_clock.hpp"

#include <gtest/gtest.h>

namespace piae::monitor {
namespace {

TEST(SampleClock, MeasuresTheDelayOfSamples) {
  SampleClock clock(100, 1);
  EXPECT_EQ(clock.late_by(50, 100), 0);  // the first clock time is arbitrary
  EXPECT_EQ(clock.late_by(51, 200), 0);
  EXPECT_EQ(clock.late_by(52.9, 300), 0);  // 0.9 s late, which is permitted
  EXPECT_NEAR(clock.late_by(56, 300), 4, 0.01);
  EXPECT_EQ(clock.late_by(57, 400), 0);  // on time relative to the new lag
  EXPECT_NEAR(clock.late_by(59, 450), 1.5, 0.01);
  EXPECT_EQ(clock.times(), 2U);
  EXPECT_NEAR(clock.all_s(), 5.5, 0.01);
}

TEST(SampleClock, ResetsWhenSamplesCatchUp) {
  SampleClock clock(100, 1);
  clock.late_by(0, 0);
  EXPECT_NEAR(clock.late_by(5, 0), 5, 0.01);
  EXPECT_EQ(clock.late_by(5.1, 510), 0);  // delayed samples arrive all at once
  EXPECT_NEAR(clock.late_by(8, 600), 2, 0.01);
}

/// The recorder's clock loses 100 parts per million for a day: 8.6 s.
TEST(SampleClock, ToleratesClockDrift) {
  SampleClock clock(1000 * (1 - 100e-6), 1);
  for (int s = 0; s <= 86400; ++s) {
    const auto samples = static_cast<std::uint64_t>(1000.0 * s * (1 - 200e-6));
    ASSERT_EQ(clock.late_by(s, samples), 0) << s;
  }
}

}  // namespace
}  // namespace piae::monitor

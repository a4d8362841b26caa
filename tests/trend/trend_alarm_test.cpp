#include "trend/trend_alarm.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace piae::trend {
namespace {

using monitor::AlarmState;

constexpr double minute_h = 1.0 / 60;

// 6 dB beyond the limit for 5 minutes are 0.5 dB h.
TEST(TrendAlarm, IsRaisedAfterEnoughDecibelsTimesHours) {
  TrendAlarm alarm(0.5);
  for (int minute = 1; minute < 5; ++minute) {
    EXPECT_EQ(alarm.add(6, minute_h), AlarmState::off);
    EXPECT_NEAR(alarm.evidence(), 0.2 * minute, 1e-12);
  }
  EXPECT_EQ(alarm.add(6 + 1e-9, minute_h), AlarmState::raised);
  EXPECT_EQ(alarm.add(6, minute_h), AlarmState::on);
  EXPECT_EQ(alarm.evidence(), 1);
}

TEST(TrendAlarm, IsClearedWhenTheEvidenceHasReturnedToZero) {
  TrendAlarm alarm(0.5);
  while (alarm.state() != AlarmState::raised) alarm.add(10, minute_h);
  for (int minute = 1; minute < 6; ++minute) EXPECT_EQ(alarm.add(-5, minute_h), AlarmState::on);
  EXPECT_EQ(alarm.add(-5 - 1e-9, minute_h), AlarmState::cleared);
  EXPECT_EQ(alarm.add(-5, minute_h), AlarmState::off);
  EXPECT_EQ(alarm.evidence(), 0);
}

TEST(TrendAlarm, NeedsTwoWindowsHoweverHighAndLong) {
  TrendAlarm alarm(0.5);
  EXPECT_EQ(alarm.add(std::numeric_limits<double>::infinity(), 1000), AlarmState::off);
  EXPECT_EQ(alarm.evidence(), 0.5);
  EXPECT_EQ(alarm.add(1e6, 1), AlarmState::raised);
  EXPECT_EQ(alarm.add(-1e6, 1000), AlarmState::on);
  EXPECT_EQ(alarm.add(-1e6, 1000), AlarmState::cleared);
}

// The same signal in windows ten times as often gives the same evidence.
TEST(TrendAlarm, DoesNotDependOnTheIntervalOfTheWindows) {
  TrendAlarm seldom(0.5);
  TrendAlarm often(0.5);
  for (const double excess_db : {3.0, -1.0, 4.0}) {
    seldom.add(excess_db, 0.02);
    for (int i = 0; i < 10; ++i) often.add(excess_db, 0.002);
    EXPECT_NEAR(often.evidence(), seldom.evidence(), 1e-12);
  }
}

}  // namespace
}  // namespace piae::trend

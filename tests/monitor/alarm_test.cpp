#include "monitor/alarm.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "support/errors.hpp"

namespace piae::monitor {
namespace {

/// p0 = 0.2 and p1 = 0.8: a window that looks faulty adds log 4, any other subtracts log 4. With 64
/// windows between false alarms the threshold is log 64, three such steps.
const AlarmOptions even{.healthy_share = 0.2, .faulty_share = 0.8, .hours_per_false_alarm = 1};
constexpr double windows_an_hour = 64;

/// Returns the second letters of the states; `windows` has 1 for a faulty-looking window, 0
/// otherwise.
std::string states(const std::string& windows) {
  Alarm alarm(even, windows_an_hour);
  std::string letters;
  for (const char window : windows) letters += to_string(alarm.add(window - '0'))[1];
  return letters;  // f: off, a: raised, n: on, l: cleared
}

TEST(Alarm, IsRaisedAtTheThresholdAndClearedAtZero) {
  EXPECT_EQ(states("111"), "ffa");
  EXPECT_EQ(states("11011"), "ffffa");
  EXPECT_EQ(states("000111"), "fffffa");          // healthy windows do not count in advance
  EXPECT_EQ(states("111000"), "ffannl");          // clearing takes as long as raising
  EXPECT_EQ(states("1111110000"), "ffannnnnlf");  // a long alarm takes no longer to clear
}

TEST(Alarm, KeepsItsStateBetweenThresholdAndZero) {
  EXPECT_EQ(states("10101010"), "ffffffff");
  EXPECT_EQ(states("11010101"), "ffffffff");
  EXPECT_EQ(states("11100101011"), "ffannnnnnnn");
  EXPECT_EQ(states("111000111"), "ffannlffa");
}

TEST(Alarm, WeighsAWindowByHowFaultyItLooks) {
  Alarm alarm(even, windows_an_hour);
  alarm.add(0.5);
  EXPECT_DOUBLE_EQ(alarm.evidence(), 0);  // equally likely for both machines
  alarm.add(0.75);
  EXPECT_NEAR(alarm.evidence(), 0.5 / 3, 1e-12);
  alarm.add(1);
  EXPECT_NEAR(alarm.evidence(), 1.5 / 3, 1e-12);
}

TEST(Alarm, NeedsTheDocumentedNumberOfWindows) {
  const Alarm alarm(even, windows_an_hour);
  EXPECT_NEAR(alarm.windows_to_alarm(1), 3, 1e-12);
  EXPECT_NEAR(alarm.windows_to_alarm(0.75), 6, 1e-12);
  EXPECT_TRUE(std::isinf(alarm.windows_to_alarm(0.5)));
}

/// Windows of 1024 samples at 12 kHz. The target is an alarm within 10 s of a defect.
TEST(Alarm, IsFastByDefault) {
  constexpr double windows_per_s = 12000.0 / 1024;
  const AlarmOptions defaults;
  const Alarm alarm(defaults, 3600 * windows_per_s);
  EXPECT_LT(alarm.windows_to_alarm(1) / windows_per_s, 1.5);
  EXPECT_LT(alarm.windows_to_alarm(defaults.faulty_share) / windows_per_s, 5);
}

/// Counts alarms in 200 stretches of the mean time between false alarms, in windows. The share of
/// faulty-looking windows is the highest that a healthy machine may have, so far fewer than 200 are
/// likely.
TEST(Alarm, HasAsFewFalseAlarmsAsRequested) {
  Stream random("alarm");
  const AlarmOptions options{.healthy_share = 0.1, .faulty_share = 0.5, .hours_per_false_alarm = 1};
  constexpr std::size_t windows = 2000;
  const auto alarms_at = [&](double share) {
    Alarm alarm(options, windows);
    std::size_t alarms = 0;
    for (std::size_t i = 0; i < 200 * windows; ++i) {
      const double looks_faulty = random.uniform(0, 1) < share ? 1 : 0;
      alarms += alarm.add(looks_faulty) == AlarmState::raised ? 1 : 0;
    }
    return alarms;
  };
  EXPECT_LT(alarms_at(0.1), 200U);
  EXPECT_GT(alarms_at(0.4), 200U);  // the test detects too many alarms
}

TEST(Alarm, RefusesSwappedShares) {
  EXPECT_ERROR(Alarm({.healthy_share = 0.5, .faulty_share = 0.5}, 64), Exit::usage,
               "--healthy-share 0.5 must be below --faulty-share 0.5");
}

}  // namespace
}  // namespace piae::monitor

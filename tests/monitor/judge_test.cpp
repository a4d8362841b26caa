#include "monitor/judge.hpp"

#include <gtest/gtest.h>

#include "monitor/judged.hpp"

namespace piae::monitor {
namespace {

/// Judges windows of half a second: h healthy, i and o with a fault, u unknown, s silent, p between
/// healthy and IR.
std::vector<Decision> judged(const std::string& windows, double every_s) {
  Judge judge(rig(), Alarm(three_windows, 64), every_s);
  std::vector<Decision> decisions;
  double end_s = 0;
  for (const char window : windows) {
    std::vector<float> classes{1, 0, 0};
    if (window == 'i') classes = {0, 1, 0};
    if (window == 'o') classes = {0, 0, 1};
    if (window == 'p') classes = {0.75F, 0.25F, 0};
    if (window == 's') classes.clear();
    end_s += 0.5;
    if (const auto d = judge.add({end_s, classes, window == 'u'})) decisions.push_back(*d);
  }
  if (const auto last = judge.finish()) decisions.push_back(*last);
  return decisions;
}

TEST(Judge, DecidesAtEveryWindowIfRequested) {
  EXPECT_EQ(text_of(judged("hio", 0)), "0.50 Normal off; 1.00 IR off; 1.50 OR off; ");
}

TEST(Judge, DecidesAtIntervalsAndAtTheEnd) {
  EXPECT_EQ(text_of(judged("hhhhh", 1)), "1.00 Normal off; 2.00 Normal off; 2.50 Normal off; ");
  EXPECT_EQ(text_of(judged("hhhhh", 0.7)),
            "1.00 Normal off; 1.50 Normal off; 2.50 Normal off; ");  // at 1.0, 1.5 (1.4), 2.5 (2.1)
  const auto decisions = judged("hhhhh", 1);
  EXPECT_EQ(decisions[0].windows, 2U);
  EXPECT_EQ(decisions[2].windows, 1U);
}

TEST(Judge, ReportsTheMeanOfTheWindows) {
  const auto decisions = judged("ihpp", 1);
  ASSERT_EQ(decisions.size(), 2U);
  EXPECT_NEAR(decisions[0].probability, 0.5, 1e-6);
  EXPECT_NEAR(decisions[1].probability, 0.75, 1e-6);
  EXPECT_EQ(decisions[1].label, 0);
}

TEST(Judge, ReportsAnAlarmAndItsClassAtOnce) {
  EXPECT_EQ(text_of(judged("hooohhhh", 100)),
            "2.00 OR raised OR; 3.50 Normal cleared; 4.00 Normal off; ");
  EXPECT_EQ(text_of(judged("iii", 100)), "1.50 IR raised IR; ");
  EXPECT_EQ(text_of(judged("iiioooo", 2)), "1.50 IR raised IR; 2.00 OR on IR; 3.50 OR on OR; ");
}

TEST(Judge, CountsUnknownAndSilentWindowsAsFaulty) {
  EXPECT_EQ(text_of(judged("uuu", 100)), "1.50 Normal? raised unknown; ");
  EXPECT_EQ(text_of(judged("sss", 100)), "1.50 -? raised unknown; ");
  EXPECT_EQ(text_of(judged("uhs", 100)), "1.50 Normal? off; ");
}

TEST(Judge, ReportsUnknownOnlyForItsOwnWindows) {
  EXPECT_EQ(text_of(judged("uuhhuh", 1)), "1.00 Normal? off; 2.00 Normal off; 3.00 Normal off; ");
}

TEST(Judge, CountsWindowsAndAlarms) {
  Judge judge(rig(), Alarm(three_windows, 64), 1);
  const std::vector<float> faulty{0, 1, 0};
  for (int i = 0; i < 3; ++i) (void)judge.add({1, faulty, i == 0});
  (void)judge.add({1, {}, false});
  EXPECT_EQ(judge.windows(), 4U);
  EXPECT_EQ(judge.alarms(), 1U);
  EXPECT_EQ(judge.unknown_windows(), 1U);
  EXPECT_EQ(judge.silent_windows(), 1U);
}

TEST(Decision, IsALineOfJson) {
  Decision decision{.time_s = 2.0483,
                    .windows = 12,
                    .label = 2,
                    .probability = 0.98,
                    .unknown = false,
                    .evidence = 1,
                    .alarm = AlarmState::raised,
                    .cause = "OR"};
  EXPECT_EQ(json_line(decision, rig()),
            "{\"time_s\": 2.048, \"windows\": 12, \"class\": \"OR\", \"probability\": 0.9800, "
            "\"unknown\": false, \"evidence\": 1.0000, \"alarm\": \"raised\", \"cause\": "
            "\"OR\"}\n");
  decision.label.reset();
  decision.cause.clear();
  decision.unknown = true;
  EXPECT_EQ(json_line(decision, rig()),
            "{\"time_s\": 2.048, \"windows\": 12, \"class\": null, \"probability\": 0.9800, "
            "\"unknown\": true, \"evidence\": 1.0000, \"alarm\": \"raised\", \"cause\": null}\n");
}

}  // namespace
}  // namespace piae::monitor

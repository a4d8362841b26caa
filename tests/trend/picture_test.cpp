#include "trend/picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/shown.hpp"
#include "trend/healthy_hours.hpp"

namespace piae::trend {
namespace {

using monitor::AlarmState;
using testing::HasSubstr;
using testing::Not;

/// Returns a trend of ten hours, the first two healthy, without a signal at 5 h.
Shown rising() {
  Shown shown{.machine = "fan", .names = noise_meter().names(), .limits_db = {6, 7, 6, 6, 6, 6, 6}};
  for (int hour = 1; hour <= 10; ++hour) {
    TrendPoint point{.time_s = 3600.0 * hour, .windows = 1, .evidence = hour > 7 ? 1.0 : 0.0};
    if (hour != 5) {
      point.rises = {.level_db = hour * 1.0, .watched_db = Eigen::ArrayXd::Constant(7, 2.0 * hour)};
    }
    (hour <= 2 ? shown.healthy : shown.points).push_back(point);
  }
  return shown;
}

void raise(TrendPoint& point, AlarmState state) {
  point.alarm = state;
  if (state == AlarmState::raised) point.cause = "16-32 Hz";
}

TEST(TrendPicture, NamesCurvesAndLimits) {
  const std::string picture = picture_of(rising());
  EXPECT_THAT(picture, HasSubstr(">fan: no alarm<"));
  EXPECT_THAT(picture, HasSubstr(">12.5-25 Hz (limit 7.0)<"));
  EXPECT_THAT(picture, HasSubstr(">peak (limit 6.0)<"));
  EXPECT_THAT(picture, Not(HasSubstr("line (limit")));
  EXPECT_EQ(count_of(picture, "#e0f2ea"), 3U);  // healthy hours in each panel
  EXPECT_EQ(count_of(picture, "#fbe3d6"), 0U);
}

// Eight curves of levels and one of novelty are interrupted; that of the evidence is not.
TEST(TrendPicture, InterruptsCurvesWithoutASignal) {
  Shown whole = rising();
  whole.points[2].rises = whole.points[1].rises;
  EXPECT_EQ(count_of(picture_of(rising()), "<polyline"),
            count_of(picture_of(whole), "<polyline") + 9);
}

TEST(TrendPicture, MarksAnAlarmUntilItIsCleared) {
  Shown shown = rising();
  raise(shown.points[5], AlarmState::raised);  // at 8 h
  raise(shown.points[6], AlarmState::cleared);
  const std::string picture = picture_of(shown);
  EXPECT_THAT(picture, HasSubstr(">fan: alarm at 8.00 h, 2.00 h before the end; cause: 16-32 Hz<"));
  EXPECT_EQ(count_of(picture, "#fbe3d6"), 3U);
  // 800 pixels are 10 h, from 70 on.
  EXPECT_THAT(picture, HasSubstr("<rect x=\"710.00\" y=\"92.0\" width=\"80.00\""));
  raise(shown.points[7], AlarmState::raised);
  EXPECT_THAT(picture_of(shown), HasSubstr(">fan: first alarm at 8.00 h"));
}

TEST(TrendPicture, HasAPanelForLines) {
  Shown shown = rising();
  for (const std::string name : {"inner line", "roller line", "outer line"}) {
    shown.names.push_back(name);
    shown.limits_db.push_back(6);
  }
  for (auto* const points : {&shown.healthy, &shown.points}) {
    for (TrendPoint& point : *points) {
      if (point.rises) point.rises->watched_db.conservativeResize(10);
      if (point.rises) point.rises->watched_db.tail(3) = 1;
    }
  }
  EXPECT_THAT(picture_of(shown), HasSubstr(">outer line (limit 6.0)<"));
  EXPECT_EQ(count_of(picture_of(shown), "#e0f2ea"), 4U);
}

TEST(TrendPicture, ChoosesTheUnitOfTime) {
  Shown shown = rising();
  for (TrendPoint& point : shown.points) point.time_s *= 24;
  EXPECT_THAT(picture_of(shown), HasSubstr(">days<"));
  for (TrendPoint& point : shown.points) point.time_s /= 24 * 3600;
  EXPECT_THAT(picture_of(shown), HasSubstr(">s<"));
  EXPECT_FALSE(picture_of({.names = shown.names, .limits_db = shown.limits_db}).empty());
}

}  // namespace
}  // namespace piae::trend

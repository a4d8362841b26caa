#include "trend/trend.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"
#include "trend/healthy_hours.hpp"

namespace piae::trend {
namespace {

using monitor::AlarmState;

/// A machine of noise, seen for half a second each minute.
class Watching {
 public:
  explicit Watching(double healthy_h = 0.5, const TrendOptions& options = {}, double every_s = 0)
      : trend(noise_meter(), options, healthy_h, every_s) {}

  /// Adds windows of this RMS; 0 is a dead sensor.
  void minutes(int count, double rms) {
    for (int i = 0; i < count; ++i) {
      const std::vector<float> window =
          rms > 0 ? noise_window(random_, rms) : std::vector<float>(noise_length, 1.5F);
      trend.add({.start_s = 60.0 * minute_++, .samples = window}, report());
    }
  }
  void finish() { trend.finish(report()); }
  /// Returns the minute of the first point in this state, or -1.
  [[nodiscard]] int first(AlarmState state) const {
    for (const TrendPoint& point : points) {
      if (point.alarm == state) return static_cast<int>(point.time_s / 60);
    }
    return -1;
  }

  Trend trend;
  std::vector<TrendPoint> points;

 private:
  Trend::Report report() {
    return [this](const TrendPoint& point) { points.push_back(point); };
  }
  Stream random_{"watching"};
  int minute_ = 0;
};

TEST(Trend, IsQuietWhileTheMachineIsHealthy) {
  Watching machine;
  machine.minutes(600, 1);
  EXPECT_EQ(machine.points.size(), 570U);
  EXPECT_EQ(machine.trend.alarms(), 0U);
  EXPECT_EQ(machine.trend.windows(), 600U);
  EXPECT_EQ(machine.points.front().time_s, 30 * 60 + 0.5);
  EXPECT_EQ(machine.trend.healthy_points().size(), 30U);
}

// Four times the amplitude is 12 dB: about 7 dB beyond the limit of the band that scatters most.
// 0.5 dB h / 7 dB are 4 to 5 minutes.
TEST(Trend, RaisesAnAlarmMinutesAfterALargeRise) {
  Watching machine;
  machine.minutes(60, 1);
  machine.minutes(60, 4);
  EXPECT_GE(machine.first(AlarmState::raised), 61);
  EXPECT_LE(machine.first(AlarmState::raised), 65);
  EXPECT_EQ(machine.trend.alarms(), 1U);
  EXPECT_NEAR(machine.points.back().rises->level_db, 12.04, 1);
  machine.minutes(120, 1);
  EXPECT_GE(machine.first(AlarmState::cleared), 120);
  EXPECT_EQ(machine.points.back().alarm, AlarmState::off);
  EXPECT_EQ(machine.points.back().cause, "");
}

// A rise below 6 dB never counts, for however long.
TEST(Trend, ToleratesRisesBelowTheLimit) {
  Watching machine;
  machine.minutes(60, 1);
  machine.minutes(600, 1.3);
  EXPECT_EQ(machine.first(AlarmState::raised), -1);
}

TEST(Trend, ToleratesASingleShock) {
  Watching machine;
  machine.minutes(60, 1);
  machine.minutes(1, 1000);
  machine.minutes(30, 1);
  EXPECT_EQ(machine.first(AlarmState::raised), -1);
}

TEST(Trend, NamesTheFeatureThatRose) {
  Watching machine;
  machine.minutes(60, 1);
  Stream random("tone");
  for (int minute = 60; minute < 90; ++minute) {
    std::vector<float> window = noise_window(random);
    for (std::size_t i = 0; i < window.size(); ++i) {
      window[i] += static_cast<float>(2 * std::sin(0.2 * static_cast<double>(i)));  // 32.6 Hz
    }
    machine.trend.add({.start_s = 60.0 * minute, .samples = window},
                      [&](const TrendPoint& point) { machine.points.push_back(point); });
  }
  EXPECT_EQ(machine.points.back().cause, "25-50 Hz");
  EXPECT_EQ(machine.points.back().alarm, AlarmState::on);
}

TEST(Trend, CountsADeadSensorAsFaulty) {
  Watching machine;
  machine.minutes(60, 1);
  machine.minutes(2, 0);
  EXPECT_EQ(machine.first(AlarmState::raised), 61);
  EXPECT_EQ(machine.points.back().cause, "no signal");
  EXPECT_FALSE(machine.points.back().rises.has_value());
}

TEST(Trend, LeavesConstantWindowsOutOfTheBaseline) {
  Watching machine;
  machine.minutes(10, 0);
  machine.minutes(20, 1);
  machine.minutes(1, 1);
  EXPECT_EQ(machine.trend.healthy()->windows().size(), 20U);
  Watching dead;
  dead.minutes(23, 0);
  dead.minutes(7, 1);
  EXPECT_ERROR(dead.minutes(1, 1), Exit::bad_input, "hold 7 windows with a signal");
}

TEST(Trend, MakesTheBaselineOfASignalThatEndsWithTheHealthyHours) {
  Watching machine(0.5 - 59.5 / 3600);
  machine.minutes(30, 1);
  EXPECT_FALSE(machine.trend.healthy().has_value());
  machine.finish();
  EXPECT_TRUE(machine.trend.healthy().has_value());
  Watching shorter;
  shorter.minutes(29, 1);
  shorter.finish();
  EXPECT_FALSE(shorter.trend.healthy().has_value());
}

TEST(Trend, ReportsInIntervalsAndAtOnceWhenTheAlarmChanges) {
  Watching machine(0.5, {}, 600);
  machine.minutes(62, 1);
  machine.minutes(20, 100);
  machine.finish();
  std::vector<int> minutes;
  for (const TrendPoint& point : machine.points) {
    minutes.push_back(static_cast<int>(point.time_s / 60));
  }
  EXPECT_THAT(minutes, testing::ElementsAre(30, 40, 50, 60, 63, 70, 80, 81));
  EXPECT_EQ(machine.points[1].windows, 10U);
  EXPECT_EQ(machine.points[4].alarm, AlarmState::raised);
}

TEST(Trend, ComparesWithAKeptBaselineFromTheStart) {
  Watching machine;
  machine.minutes(31, 1);
  Trend later({.meter = noise_meter(), .windows = machine.trend.healthy()->windows()}, {}, 0);
  std::vector<TrendPoint> points;
  const auto report = [&](const TrendPoint& point) { points.push_back(point); };
  Stream random("later");
  for (int minute = 0; minute < 10; ++minute) {
    const std::vector<float> window = noise_window(random, 10);
    later.add({.start_s = 60.0 * minute, .samples = window}, report);
  }
  EXPECT_EQ(points.size(), 10U);
  EXPECT_EQ(points.back().alarm, AlarmState::on);
  EXPECT_TRUE(later.healthy_points().empty());
}

}  // namespace
}  // namespace piae::trend

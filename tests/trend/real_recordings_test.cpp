// Tries the alarm on the learning set of PRONOSTIA, if the environment variable DATA_DIR is set,
// and prints the table of docs/monitoring.md: how long before the end of its life each bearing
// raises an alarm on one of its two axes, by the trend and by three rivals.
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>

#include "signal/ingest.hpp"
#include "trend/snapshots.hpp"
#include "trend/trend.hpp"

namespace piae::trend {
namespace {

namespace fs = std::filesystem;

constexpr double healthy_h = 0.25;
constexpr double healthy_h_of_rivals = 0.5;  // with less they raise more false alarms
constexpr double early = 0.3;                // share of a life in which no alarm may be raised

/// One bearing's life, on two axes.
struct Life {
  std::string name;
  std::vector<signal::Record> axes;
  signal::DatasetInfo info;

  [[nodiscard]] double interval_h() const { return *axes.front().snapshot_interval_s / 3600; }
  [[nodiscard]] double hours() const {
    return static_cast<double>(axes.front().pieces.size()) * interval_h();
  }
};

/// Time of an alarm in h, if there is one.
using Alarm = std::optional<double>;

bool is_early(const Alarm& alarm, const Life& life) {
  return alarm && *alarm < early * life.hours();
}

Alarm earlier(const Alarm& one, const Alarm& other) {
  if (!one || !other) return one ? one : other;
  return std::min(*one, *other);
}

Alarm alarm_of_trend(const Life& life) {
  const double rate_hz = life.info.sample_rate_hz;
  Alarm first;
  for (const signal::Record& axis : life.axes) {
    const std::size_t length = window_of(axis, rate_hz, 0);
    const FeatureMeter meter(rate_hz, length,
                             lines_shown(life.info.bearing, axis.shaft_speed_rpm, rate_hz, length));
    Trend trend(meter, {}, healthy_h, 0);
    Alarm alarm;
    const auto report = [&](const TrendPoint& point) {
      if (!alarm && point.alarm == monitor::AlarmState::raised) {
        alarm = (point.time_s - meter.window_s()) / 3600;
      }
    };
    for_each_window(axis, rate_hz, length,
                    [&](const TimedWindow& window) { trend.add(window, report); });
    first = earlier(first, alarm);
  }
  return first;
}

/// RMS, kurtosis and peak of each snapshot, on the first axis and then on the second.
using Measured = std::array<std::vector<double>, 6>;

void measure(std::span<const float> window, Measured& all, std::size_t first) {
  const auto n = static_cast<double>(window.size());
  double mean = 0;
  for (const double x : window) mean += x / n;
  double squares = 0;
  double fourths = 0;
  double peak = 0;
  for (const double x : window) {
    squares += std::pow(x - mean, 2) / n;
    fourths += std::pow(x - mean, 4) / n;
    peak = std::max(peak, std::abs(x - mean));
  }
  all.at(first).push_back(std::sqrt(squares));
  all.at(first + 1).push_back(fourths / (squares * squares));
  all.at(first + 2).push_back(peak);
}

Measured measured(const Life& life) {
  Measured all;
  const double rate_hz = life.info.sample_rate_hz;
  for (std::size_t i = 0; i < life.axes.size(); ++i) {
    for_each_window(life.axes[i], rate_hz, window_of(life.axes[i], rate_hz, 0),
                    [&](const TimedWindow& window) { measure(window.samples, all, 3 * i); });
  }
  return all;
}

/// Raises an alarm when two successive snapshots exceed the healthy mean by `k` standard
/// deviations.
Alarm alarm_of_rule(const std::vector<double>& values, double k, double interval_h) {
  const auto healthy = static_cast<std::size_t>(std::ceil(healthy_h_of_rivals / interval_h - 1e-9));
  double mean = 0;
  double squares = 0;
  for (std::size_t i = 0; i < healthy; ++i) mean += values[i] / static_cast<double>(healthy);
  for (std::size_t i = 0; i < healthy; ++i) squares += std::pow(values[i] - mean, 2);
  const double limit = mean + k * std::sqrt(squares / static_cast<double>(healthy - 1));
  for (std::size_t i = healthy + 1; i < values.size(); ++i) {
    if (values[i - 1] > limit && values[i] > limit) return static_cast<double>(i) * interval_h;
  }
  return std::nullopt;
}

/// A rule on one of the measures, or on any of them.
struct Rival {
  std::string name;
  std::vector<std::size_t> measures;
};

Alarm alarm_of(const Rival& rival, const Measured& values, double k, double interval_h) {
  Alarm first;
  for (const std::size_t measure : rival.measures) {
    first = earlier(first, alarm_of_rule(values.at(measure), k, interval_h));
  }
  return first;
}

/// Returns the smallest multiple from 3 on, in steps of 0.25, without an early alarm.
double fair_multiple(const Rival& rival, const std::vector<Life>& lives,
                     const std::vector<Measured>& values) {
  for (double k = 3;; k += 0.25) {
    bool any_early = false;
    for (std::size_t i = 0; i < lives.size(); ++i) {
      any_early |= is_early(alarm_of(rival, values[i], k, lives[i].interval_h()), lives[i]);
    }
    if (!any_early) return k;
  }
}

std::string lead(const Alarm& alarm, const Life& life) {
  // A snapshot's time is its start; the last one starts an interval before the end.
  return alarm ? fmt::format("{:.2f}", life.hours() - life.interval_h() - *alarm) : "none";
}

/// Returns the bearings; none if the recordings are missing. Records have conditions such as
/// "Bearing1_1-H".
std::vector<Life> read_lives() {
  const char* const folder = std::getenv("DATA_DIR");
  if (folder == nullptr || !fs::exists(fs::path(folder) / "pronostia")) return {};
  const signal::Description description =
      signal::read_description(fs::path(PIAE_SOURCE) / "pipeline" / "trends" / "pronostia.toml");
  signal::RecordReader reader(description, folder);
  std::vector<Life> lives;
  for (const signal::RecordSource& source : description.records) {
    const std::string name = source.condition.substr(0, source.condition.find('-'));
    if (lives.empty() || lives.back().name != name) lives.push_back({name, {}, description.info});
    lives.back().axes.push_back(reader.read(source));
  }
  return lives;
}

TEST(Pronostia, EveryBearingRaisesAnAlarmBeforeItsEndAndNoneEarly) {
  const std::vector<Life> lives = read_lives();
  if (lives.empty()) GTEST_SKIP() << "DATA_DIR does not have pronostia/";
  ASSERT_EQ(lives.size(), 6U);
  const std::vector<Rival> rivals{
      {"RMS", {0, 3}}, {"kurtosis", {1, 4}}, {"any", {0, 1, 2, 3, 4, 5}}};
  std::vector<Measured> values;
  for (const Life& life : lives) values.push_back(measured(life));
  std::vector<double> multiples;
  for (const Rival& rival : rivals) multiples.push_back(fair_multiple(rival, lives, values));
  std::cout << fmt::format("bearing     life h  alarm h     %  lead h");
  for (std::size_t r = 0; r < rivals.size(); ++r) {
    std::cout << fmt::format("  {} (k={:g})", rivals[r].name, multiples[r]);
  }
  std::cout << '\n';
  for (std::size_t i = 0; i < lives.size(); ++i) {
    const Life& life = lives[i];
    const Alarm alarm = alarm_of_trend(life);
    ASSERT_TRUE(alarm.has_value()) << life.name;
    EXPECT_FALSE(is_early(alarm, life)) << life.name;
    std::cout << fmt::format("{}  {:6.2f}  {:7.2f}  {:4.0f}  {:>6}", life.name, life.hours(),
                             *alarm, 100 * *alarm / life.hours(), lead(alarm, life));
    for (std::size_t r = 0; r < rivals.size(); ++r) {
      const Alarm other = alarm_of(rivals[r], values[i], multiples[r], life.interval_h());
      const Alarm at_3 = alarm_of(rivals[r], values[i], 3, life.interval_h());
      std::cout << fmt::format("  {} (k=3: {}{})", lead(other, life), lead(at_3, life),
                               is_early(at_3, life) ? ", early" : "");
    }
    std::cout << '\n';
  }
}

}  // namespace
}  // namespace piae::trend

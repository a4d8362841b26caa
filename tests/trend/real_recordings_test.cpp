// Tries the alarm on the learning set of PRONOSTIA, if the environment variable DATA_DIR is set,
// and prints the table of docs/monitoring.md: how long before the end of its life each bearing
// raises an alarm, by the trend and by three rivals.
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>

#include "signal/ingest.hpp"
#include "signal/record_files.hpp"
#include "trend/session.hpp"
#include "trend/snapshots.hpp"

namespace piae::trend {
namespace {

namespace fs = std::filesystem;

constexpr double healthy_h = 0.5;
constexpr double early = 0.3;  // share of a life in which no alarm may be raised

/// One bearing's life.
struct Life {
  std::string name;
  signal::Record record;
  signal::DatasetInfo info;

  [[nodiscard]] double interval_h() const { return *record.snapshot_interval_s / 3600; }
  [[nodiscard]] double hours() const {
    return static_cast<double>(record.pieces.size()) * interval_h();
  }
};

/// Time of an alarm in h, if there is one.
using Alarm = std::optional<double>;

bool is_early(const Alarm& alarm, const Life& life) {
  return alarm && *alarm < early * life.hours();
}

Alarm alarm_of_trend(const Life& life) {
  const double rate_hz = life.info.sample_rate_hz;
  const std::size_t length = window_of(life.record, rate_hz, 0);
  const FeatureMeter meter(
      rate_hz, length,
      lines_shown(life.info.bearing, life.record.shaft_speed_rpm, rate_hz, length));
  Trend trend(meter, {}, healthy_h, 0);
  Alarm alarm;
  const auto report = [&](const TrendPoint& point) {
    if (!alarm && point.alarm == monitor::AlarmState::raised) alarm = point.time_s / 3600;
  };
  for_each_window(life.record, rate_hz, length, [&](double start_s, std::span<const float> window) {
    trend.add(start_s, window, report);
  });
  return alarm;
}

/// RMS, kurtosis and peak of each snapshot.
using Measured = std::array<std::vector<double>, 3>;

Measured measured(const Life& life) {
  Measured all;
  const double rate_hz = life.info.sample_rate_hz;
  for_each_window(life.record, rate_hz, window_of(life.record, rate_hz, 0),
                  [&](double /*start_s*/, std::span<const float> window) {
                    double mean = 0;
                    for (const double x : window) mean += x / static_cast<double>(window.size());
                    double squares = 0;
                    double fourths = 0;
                    double peak = 0;
                    for (const double x : window) {
                      const double square = (x - mean) * (x - mean);
                      squares += square / static_cast<double>(window.size());
                      fourths += square * square / static_cast<double>(window.size());
                      peak = std::max(peak, std::abs(x - mean));
                    }
                    all[0].push_back(std::sqrt(squares));
                    all[1].push_back(fourths / (squares * squares));
                    all[2].push_back(peak);
                  });
  return all;
}

/// Raises an alarm when two successive snapshots exceed the healthy mean by `k` standard
/// deviations.
Alarm alarm_of_rule(const std::vector<double>& values, double k, double interval_h) {
  const auto healthy = static_cast<std::size_t>(std::ceil(healthy_h / interval_h - 1e-9));
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
    const Alarm alarm = alarm_of_rule(values.at(measure), k, interval_h);
    if (alarm && (!first || *alarm < *first)) first = alarm;
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

std::vector<Life> read_lives() {
  const char* const folder = std::getenv("DATA_DIR");
  if (folder == nullptr || !fs::exists(fs::path(folder) / "pronostia")) return {};
  const signal::Description description =
      signal::read_description(fs::path(PIAE_SOURCE) / "pipeline" / "trends" / "pronostia.toml");
  signal::RecordReader reader(description, folder);
  std::vector<Life> lives;
  for (const signal::RecordSource& source : description.records) {
    lives.push_back({source.condition, reader.read(source), description.info});
  }
  return lives;
}

TEST(Pronostia, EveryBearingRaisesAnAlarmBeforeItsEndAndNoneEarly) {
  const std::vector<Life> lives = read_lives();
  if (lives.empty()) GTEST_SKIP() << "DATA_DIR does not have pronostia/";
  ASSERT_EQ(lives.size(), 6U);
  const std::vector<Rival> rivals{{"RMS", {0}}, {"kurtosis", {1}}, {"3 sigma", {0, 1, 2}}};
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

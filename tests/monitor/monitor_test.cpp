#include "monitor/monitor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "monitor/judged.hpp"
#include "signal/amplitude.hpp"
#include "support/turning_shaft.hpp"

namespace piae::monitor {
namespace {

constexpr std::size_t window_length = 100;  // a tenth of a second

/// Classifies windows by their mean: above 0 an outer race fault, above 10 unknown, too.
diagnosis::Predictions by_mean(const signal::WindowSet& windows) {
  diagnosis::Predictions predictions;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const double mean = signal::mean_of(windows.window(i));
    const Label label = mean > 0 ? 2 : 0;
    predictions.labels.push_back(label);
    for (Label c = 0; c < 3; ++c) predictions.probabilities.push_back(c == label ? 1.0F : 0.0F);
    predictions.novelty.push_back(mean > 10 ? 1.5 : 0.5);
  }
  return predictions;
}

/// Appends `samples` samples of a wave about `level`; its phase continues.
void append_wave(std::vector<float>& signal, double level, std::size_t samples,
                 double rate_hz = 1000) {
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(signal.size()) / rate_hz;
    signal.push_back(static_cast<float>(level + 0.3 * std::sin(2 * std::numbers::pi * 50 * t)));
  }
}

MonitorOptions options_at(double rate_hz, double every_s = 0) {
  MonitorOptions options;
  options.sample_rate_hz = rate_hz;
  options.speed_rpm = 1500;
  options.every_s = every_s;
  // Three windows raise the alarm and three clear it, as in judged.hpp.
  options.alarm = three_windows;
  options.alarm.hours_per_false_alarm = 64.0 * window_length / (3600 * 1000);
  return options;
}

struct Monitored {
  std::vector<Decision> decisions;
  std::uint64_t samples = 0;
  std::uint64_t not_finite = 0;
  std::size_t silent = 0;
};

Monitored watched(const std::vector<float>& signal, const MonitorOptions& options,
                  std::size_t piece) {
  Monitor monitor(rig(), window_length, by_mean, options, "raw");
  Monitored watched;
  const auto report = [&](const Decision& d) { watched.decisions.push_back(d); };
  const auto bytes = std::as_bytes(std::span(signal));
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    monitor.add(bytes.subspan(at, std::min(piece, bytes.size() - at)), report);
  }
  monitor.finish(report);
  watched.samples = monitor.feed().samples();
  watched.not_finite = monitor.feed().samples_not_finite();
  watched.silent = monitor.judge().silent_windows();
  return watched;
}

TEST(Monitor, DoesNotDependOnThePiecesOfTheStream) {
  std::vector<float> signal;
  append_wave(signal, -1, 450);
  append_wave(signal, 2, 500);
  append_wave(signal, -1, 333);
  const std::string expected =
      "0.10 Normal off; 0.20 Normal off; 0.30 Normal off; 0.40 Normal off; 0.50 OR off; "
      "0.60 OR off; 0.70 OR raised OR; 0.80 OR on OR; 0.90 OR on OR; 1.00 OR on OR; "
      "1.10 Normal on OR; 1.20 Normal on OR; ";
  for (const std::size_t piece : {1, 3, 4, 399, 400, 401, 1000, 100000}) {
    EXPECT_EQ(text_of(watched(signal, options_at(1000), piece).decisions), expected) << piece;
  }
}

TEST(Monitor, ResamplesAFasterStream) {
  std::vector<float> fast;
  append_wave(fast, -1, 2250, 5000);
  append_wave(fast, 2, 2500, 5000);
  for (const std::size_t piece : {4, 1000, 100000}) {
    EXPECT_EQ(text_of(watched(fast, options_at(5000), piece).decisions),
              "0.10 Normal off; 0.20 Normal off; 0.30 Normal off; 0.40 Normal off; 0.50 OR off; "
              "0.60 OR off; 0.70 OR raised OR; 0.80 OR on OR; 0.90 OR on OR; ")
        << piece;
  }
}

/// Two blocks of 10 s show 1560 rpm.
TEST(Monitor, GivesWindowsTheSpeedOfTheStream) {
  std::vector<float> signal(40000);
  for (unsigned seed = 1; seed <= 16; ++seed) {  // their harmonics add up, their noise less so
    const std::vector<double> shaft = turning_shaft(1560, signal.size(), 1000, seed);
    for (std::size_t i = 0; i < shaft.size(); ++i) signal[i] += static_cast<float>(shaft[i]);
  }
  MonitorOptions options = options_at(1000);
  options.speed_search_percent = 10;
  std::vector<double> speeds_rpm;
  const auto predict = [&](const signal::WindowSet& windows) {
    speeds_rpm.insert(speeds_rpm.end(), windows.shaft_speed_rpm.begin(),
                      windows.shaft_speed_rpm.end());
    return by_mean(windows);
  };
  Monitor monitor(rig(), window_length, predict, options, "raw");
  monitor.add(std::as_bytes(std::span(signal)), [](const Decision&) {});
  monitor.finish([](const Decision&) {});
  ASSERT_EQ(speeds_rpm.size(), 400U);
  EXPECT_EQ(speeds_rpm[0], 1500);
  EXPECT_EQ(speeds_rpm[198], 1500);
  EXPECT_NEAR(speeds_rpm[199], 1560, 2);
  EXPECT_NEAR(speeds_rpm[399], 1560, 2);
}

TEST(Monitor, CutsNoWindowAcrossNonFiniteSamples) {
  std::vector<float> signal;
  append_wave(signal, -1, 150);
  signal.insert(signal.end(), 30, std::numeric_limits<float>::quiet_NaN());
  append_wave(signal, 2, 120);
  signal.push_back(std::numeric_limits<float>::infinity());
  append_wave(signal, 2, 99);
  for (const std::size_t piece : {4, 7, 4000}) {
    const Monitored all = watched(signal, options_at(1000), piece);
    EXPECT_EQ(text_of(all.decisions), "0.10 Normal off; 0.28 OR off; ") << piece;
    EXPECT_EQ(all.samples, 400U);
    EXPECT_EQ(all.not_finite, 31U);
  }
}

/// Windows hold 32-bit floats, and resampled samples may exceed the original ones.
TEST(Monitor, CutsNoWindowAcrossHugeSamples) {
  for (const double rate_hz : {1000.0, 3000.0}) {
    std::vector<double> signal;
    for (std::size_t i = 0; i < 6000; ++i) signal.push_back(i % 7 == 0 ? 1 : -1);
    signal[2150] = 1e300;
    signal[2250] = -1e39;
    for (std::size_t i = 4000; i < 4400; ++i) signal[i] = (i / 3) % 2 == 0 ? 3.4e38 : -3.4e38;
    bool finite = true;
    const auto classify_windows = [&](const signal::WindowSet& windows) {
      for (const float x : windows.samples) finite = finite && std::isfinite(x);
      return by_mean(windows);
    };
    MonitorOptions options = options_at(rate_hz);
    options.format = SampleFormat::f64;
    Monitor monitor(rig(), window_length, classify_windows, options, "raw");
    std::vector<double> ends_s;
    const auto report = [&](const Decision& d) { ends_s.push_back(d.time_s); };
    monitor.add(std::as_bytes(std::span(signal)), report);
    monitor.finish(report);
    EXPECT_TRUE(finite) << rate_hz;
    EXPECT_EQ(monitor.feed().samples_not_finite(), 402U);
    const auto spans_the_gap = [&](double end_s) {
      const double begin = (end_s - monitor.window_s()) * rate_hz;
      return begin < 4399.5 && end_s * rate_hz > 4000.5;
    };
    EXPECT_TRUE(std::ranges::none_of(ends_s, spans_the_gap)) << rate_hz;
    EXPECT_NEAR(ends_s.back(), 6000 / rate_hz, monitor.window_s());
  }
}

/// Each line takes the time of one sample, whatever its text.
TEST(Monitor, CutsNoWindowAcrossInvalidLines) {
  std::string text = "time\n";
  for (int i = 1; i < 450; ++i) {
    text += i == 130 ? "4.2.3\n" : i == 131 ? "nan\n" : i % 2 == 0 ? "+1.5\n" : "-1.75\n";
  }
  MonitorOptions options = options_at(1000);
  options.format = SampleFormat::text;
  Monitor monitor(rig(), window_length, by_mean, options, "raw");
  std::vector<Decision> decisions;
  monitor.add(std::as_bytes(std::span(text)), [&](const Decision& d) { decisions.push_back(d); });
  EXPECT_EQ(text_of(decisions),
            "0.10 Normal off; 0.23 Normal off; 0.33 Normal off; 0.43 Normal off; ");
  EXPECT_EQ(monitor.feed().samples(), 450U);
  EXPECT_EQ(monitor.feed().samples_not_finite(), 1U);
  EXPECT_EQ(monitor.feed().decoder().text().garbled(), 2U);
}

TEST(Monitor, CutsNoWindowAcrossABreak) {
  std::vector<float> signal;
  append_wave(signal, -1, 150);
  Monitor monitor(rig(), window_length, by_mean, options_at(1000), "raw");
  std::vector<Decision> decisions;
  const auto report = [&](const Decision& d) { decisions.push_back(d); };
  monitor.add(std::as_bytes(std::span(signal)).first(599), report);
  EXPECT_EQ(monitor.feed().decoder().waiting(), 3U);
  monitor.skip();
  EXPECT_EQ(monitor.feed().decoder().waiting(), 0U);
  monitor.add(std::as_bytes(std::span(signal)), report);
  EXPECT_EQ(text_of(decisions), "0.10 Normal off; 0.24 Normal off; ");
}

TEST(Monitor, ReportsASilentSensorAsNotHealthy) {
  const std::vector<float> dead(400, 0.25F);
  const Monitored all = watched(dead, options_at(1000), 1000);
  EXPECT_EQ(text_of(all.decisions),
            "0.10 -? off; 0.20 -? off; 0.30 -? raised unknown; 0.40 -? on unknown; ");
  EXPECT_EQ(all.silent, 4U);
}

TEST(Monitor, ReportsANovelWindowAsUnknown) {
  std::vector<float> signal;
  append_wave(signal, 20, 300);
  EXPECT_EQ(text_of(watched(signal, options_at(1000), 1000).decisions),
            "0.10 OR? off; 0.20 OR? off; 0.30 OR? raised unknown; ");
}

/// Fault lines depend on the shaft's own speed, not on the data set's.
TEST(Monitor, PassesTheShaftSpeedToTheClassifier) {
  signal::DatasetInfo slower = rig();
  slower.conditions = {{.name = "fast", .shaft_speed_rpm = 1500},
                       {.name = "slow", .shaft_speed_rpm = 1200}};
  std::vector<double> speeds_rpm;
  std::vector<std::int32_t> conditions;
  const auto classify_windows = [&](const signal::WindowSet& windows) {
    for (std::size_t i = 0; i < windows.size(); ++i) speeds_rpm.push_back(windows.speed_rpm(i));
    conditions.insert(conditions.end(), windows.condition.begin(), windows.condition.end());
    return by_mean(windows);
  };
  MonitorOptions options = options_at(1000);
  options.speed_rpm = 1190;
  Monitor monitor(slower, window_length, classify_windows, options, "raw");
  std::vector<float> signal;
  append_wave(signal, -1, window_length);
  signal.insert(signal.end(), window_length, 0.25F);  // silent
  append_wave(signal, 2, window_length);
  monitor.add(std::as_bytes(std::span(signal)), [](const Decision&) {});
  EXPECT_EQ(speeds_rpm, (std::vector<double>{1190, 1190}));
  EXPECT_EQ(conditions, (std::vector<std::int32_t>(2, signal::every_condition)));
}

TEST(Monitor, JudgesManyWindowsInOrder) {
  std::vector<float> signal;
  for (int i = 0; i < 200; ++i) append_wave(signal, i % 4 == 0 ? 2 : -1, window_length);
  const auto all = watched(signal, options_at(1000), signal.size() * sizeof(float)).decisions;
  ASSERT_EQ(all.size(), 200U);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].label, i % 4 == 0 ? 2 : 0) << i;
}

}  // namespace
}  // namespace piae::monitor

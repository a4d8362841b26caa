#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <limits>

#include "base/random.hpp"
#include "stages/tiny.hpp"

/// `monitor --healthy`: an alarm from healthy data alone.
namespace piae::stages {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* run_description = R"(name = "fan"
sample_rate_hz = 12000
shaft_speed_rpm = 1797
{}
[[class]]
name = "run"
defect = "none"

[[record]]
class = "run"
file = "run/acc_*.csv"
variable = "1"
sample_rate_hz = 12000
snapshot_interval_s = {}
)";

constexpr const char* skf_6205 = R"([bearing]
balls = 9
ball_diameter_mm = 7.94
pitch_diameter_mm = 39
contact_angle_deg = 0
)";

class Trended : public testing::Test {
 protected:
  /// Returns a second of noise at 1 kHz for each level.
  static std::string stream_of(const std::vector<double>& levels) {
    Stream random("stream");
    std::string bytes;
    for (const double level : levels) {
      for (int i = 0; i < 1000; ++i) {
        const auto x = static_cast<float>(level > 0 ? random.normal(0, level) : 1);
        bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
      }
    }
    return bytes;
  }
  static std::vector<double> levels(int before, int after, double level) {
    std::vector<double> all(static_cast<std::size_t>(before), 1.0);
    all.resize(static_cast<std::size_t>(before + after), level);
    return all;
  }
  /// Writes snapshots of 1200 samples, the last ones ten times as strong, and ingests them.
  void ingest(int quiet, int strong, const std::string& bearing = "",
              const std::string& interval_s = "600") const {
    Stream random("snapshots");
    for (int i = 1; i <= quiet + strong; ++i) {
      std::string text;
      for (int k = 0; k < 1200; ++k) {
        text += fmt::format("{:.4f}\n", random.normal(0, i <= quiet ? 1 : 10));
      }
      folder_.write(fmt::format("run/acc_{}.csv", i), text);
    }
    folder_.write("fan.toml", fmt::format(fmt::runtime(run_description), bearing, interval_s));
    const Outcome outcome =
        run(folder_.path(), "ingest",
            {"--description", "fan.toml", "--data-dir", ".", "--output", "records.h5"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  /// Watches raw.f32 at 1 kHz; half a minute of it is healthy.
  [[nodiscard]] Outcome watch(const Arguments& more) const {
    Arguments all{"--input",   "raw.f32",      "--sample-rate-hz", "1000",
                  "--healthy", "0.0083333333", "--alarm-db-h",     "0.01"};
    for (std::size_t i = 0; i + 1 < more.size(); i += 2) all = with(all, more[i], more[i + 1]);
    return monitor(all);
  }
  [[nodiscard]] Outcome monitor(const Arguments& arguments) const {
    return run(folder_.path(), "monitor", arguments);
  }

  Folder folder_;
};

TEST_F(Trended, AStreamRaisesAnAlarmAfterItsLevelRose) {
  folder_.write("raw.f32", stream_of(levels(60, 30, 10)));
  const Outcome outcome = watch({});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("{\"time_s\": 31.000, \"windows\": 1, \"level_db\": "));
  // 14 dB beyond the limit for 2.6 s are 0.01 dB h
  EXPECT_THAT(outcome.out, HasSubstr("{\"time_s\": 63.000, "));
  EXPECT_THAT(outcome.out, HasSubstr("\"alarm\": \"raised\", \"cause\": \""));
  EXPECT_THAT(outcome.out, Not(HasSubstr("\"line\": \"")));
  EXPECT_THAT(outcome.err, HasSubstr("90 windows in 90.0 s of signal until its end: 1 alarm; "
                                     "nothing lost"));
}

TEST_F(Trended, AHealthyStreamRaisesNone) {
  folder_.write("raw.f32", stream_of(levels(300, 0, 1)));
  const Outcome outcome = watch({});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, Not(HasSubstr("raised")));
  EXPECT_THAT(outcome.err, HasSubstr("0 alarms; nothing lost"));
}

TEST_F(Trended, NoWindowSpansAGap) {
  std::string bytes = stream_of(levels(60, 0, 1));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  bytes.replace(40500 * sizeof nan, sizeof nan, reinterpret_cast<const char*>(&nan), sizeof nan);
  folder_.write("raw.f32", bytes);
  const Outcome outcome = watch({});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("59 windows in 60.0 s of signal"));
  EXPECT_THAT(outcome.err, HasSubstr("lost: 1 sample not finite"));
}

TEST_F(Trended, AKeptBaselineReplacesTheHealthyHours) {
  folder_.write("raw.f32", stream_of(levels(60, 0, 1)));
  const Outcome kept = watch({"--keep-baseline", "baseline.h5"});
  EXPECT_EQ(kept.status, 0) << kept.err;
  EXPECT_EQ(run(folder_.path(), "verify", {"baseline.h5"}).status, 0);
  folder_.write("raw.f32", stream_of(levels(3, 30, 10)));
  const Outcome outcome = monitor({"--input", "raw.f32", "--sample-rate-hz", "1000", "--baseline",
                                   "baseline.h5", "--alarm-db-h", "0.01"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("{\"time_s\": 1.000, "));
  EXPECT_THAT(outcome.out, HasSubstr("raised"));
  expect_refusal(
      monitor({"--input", "raw.f32", "--sample-rate-hz", "2000", "--baseline", "baseline.h5"}),
      "monitor", 65, {"baseline.h5", "1000 Hz", "2000 Hz"});
}

TEST_F(Trended, SnapshotsCountAtTheirTimes) {
  ingest(24, 4, skf_6205);
  const Outcome outcome =
      monitor({"--healthy", "2", "--records", "records.h5", "--picture", "trend.svg"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  // 12 snapshots of ten minutes are healthy; the 25th starts after 4 h, and two raise the alarm.
  EXPECT_THAT(outcome.out, StartsWith("{\"time_s\": 7200.100, \"windows\": 1, "));
  EXPECT_THAT(outcome.out, HasSubstr("\"line\": \""));
  EXPECT_THAT(outcome.out, HasSubstr("{\"time_s\": 15000.100, "));
  EXPECT_THAT(outcome.err, HasSubstr("fan run: 28 windows until 4.5 h: 1 alarm; first alarm at "
                                     "4.167 h, cause: "));
  EXPECT_THAT(bytes_of(folder_ / "trend.svg"), HasSubstr(">fan run: alarm at 4.17 h"));
}

TEST_F(Trended, SnapshotsWithoutABearingShowNoLines) {
  ingest(20, 0);
  const Outcome outcome = monitor({"--healthy", "2", "--records", "records.h5"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\"line_db\": null, \"line\": null"));
}

TEST_F(Trended, ImpossibleRequestsAreRefused) {
  folder_.write("raw.f32", stream_of(levels(60, 0, 1)));
  const Arguments stream{"--input", "raw.f32", "--sample-rate-hz", "1000"};
  expect_refusal(monitor(stream), "monitor", 2,
                 {"exactly one of --classifier, --healthy and --baseline"});
  expect_refusal(watch({"--classifier", "raw.f32"}), "monitor", 2, {"exactly one of"});
  expect_refusal(monitor({"--classifier", "c.h5", "--picture", "trend.svg"}), "monitor", 2,
                 {"--picture need"});
  expect_refusal(monitor({"--classifier", "c.h5"}), "monitor", 2, {"--sample-rate-hz is required"});
  expect_refusal(monitor({"--healthy", "1", "--input", "raw.f32"}), "monitor", 2,
                 {"--sample-rate-hz is required"});
  expect_refusal(watch({"--healthy", "0"}), "monitor", 2, {"--healthy"});
  expect_refusal(watch({"--healthy", "nan"}), "monitor", 2, {"--healthy"});
  expect_refusal(watch({"--record", "run"}), "monitor", 2, {"--record needs --records"});
  expect_refusal(watch({"--picture", "raw.f32"}), "monitor", 2, {"raw.f32"});
  expect_refusal(monitor({"--healthy", "1", "--records", "nowhere.h5"}), "monitor", 66,
                 {"nowhere.h5"});
  expect_refusal(monitor({"--baseline", "raw.f32", "--input", "raw.f32", "--sample-rate-hz", "9"}),
                 "monitor", 65, {"raw.f32"});
}

TEST_F(Trended, ASignalThatCannotServeIsRefused) {
  folder_.write("raw.f32", stream_of(levels(60, 0, 1)));
  const auto refused = [&](const Arguments& more, const std::vector<std::string>& words) {
    const Outcome outcome = watch(with(more, "--picture", "trend.svg"));
    EXPECT_EQ(outcome.status, 65) << outcome.err;
    for (const std::string& word : words) EXPECT_THAT(outcome.err, HasSubstr(word));
    EXPECT_FALSE(fs::exists(folder_ / "trend.svg"));
  };
  refused({"--healthy", "1"}, {"ends after 0.0167 h, within its first 1 h", "--healthy"});
  refused({"--window-s", "10"}, {"hold 3 windows", "needs 8"});
  refused({"--window-s", "0.1"}, {"100 samples are too short"});
  folder_.write("raw.f32", stream_of(std::vector<double>(60, 0)));
  refused({"--every-s", "1"}, {"hold 0 windows with a signal"});
  folder_.write("raw.f32", "");
  refused({"--every-s", "1"}, {"raw.f32: ended after 0 samples"});
}

TEST_F(Trended, SnapshotsThatCannotServeAreRefused) {
  ingest(10, 0);
  const auto refused = [&](const Arguments& more, const std::vector<std::string>& words) {
    Arguments all{"--healthy", "1", "--records", "records.h5"};
    all.insert(all.end(), more.begin(), more.end());
    expect_refusal(monitor(all), "monitor", 65, words);
  };
  refused({}, {"records.h5", "hold 6 windows"});
  refused({"--window-s", "0.2"}, {"longest piece has 1200 samples, but a window has 2400"});
  refused({"--record", "other"}, {"does not have a record other; known: run"});
}

TEST_F(Trended, SnapshotsThatOverlapAreRefused) {
  folder_.write("run/acc_1.csv", "1\n2\n3\n4\n");
  folder_.write("run/acc_2.csv", "1\n2\n3\n5\n");
  const Arguments arguments{"--description", "fan.toml", "--data-dir", ".", "--output", "r.h5"};
  folder_.write("fan.toml", fmt::format(fmt::runtime(run_description), "", "0.001"));
  EXPECT_EQ(run(folder_.path(), "ingest", arguments).status, 0);
  std::string longer;
  for (int i = 0; i < 13; ++i) longer += fmt::format("{}\n", i);
  folder_.write("run/acc_1.csv", longer);
  expect_refusal(run(folder_.path(), "ingest", arguments), "ingest", 65,
                 {"run/acc_*.csv", "file 1 of 2 lasts 0.00108333 s", "snapshot_interval_s"});
}

}  // namespace
}  // namespace piae::stages

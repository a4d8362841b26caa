#include "trend/snapshots.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "support/errors.hpp"

namespace piae::trend {
namespace {

using testing::ElementsAre;
using testing::Pair;

signal::Record record_of(const std::vector<std::size_t>& pieces) {
  signal::Record record;
  record.name = "run";
  record.pieces = pieces;
  record.signal.resize(std::accumulate(pieces.begin(), pieces.end(), std::size_t{0}));
  std::iota(record.signal.begin(), record.signal.end(), 0.0);
  return record;
}

/// Returns start and first sample of each window at 10 Hz.
std::vector<std::pair<double, float>> windows_of(const signal::Record& record, std::size_t length) {
  std::vector<std::pair<double, float>> windows;
  for_each_window(record, 10, length, [&](const TimedWindow& window) {
    EXPECT_EQ(window.samples.size(), length);
    EXPECT_EQ(window.samples.back() - window.samples.front(), static_cast<float>(length - 1));
    windows.emplace_back(window.start_s, window.samples.front());
  });
  return windows;
}

TEST(Snapshots, GiveAWindowEachAtTheirTimes) {
  signal::Record record = record_of({5, 7, 4, 6});
  record.snapshot_interval_s = 100;
  EXPECT_EQ(window_of(record, 10, 0), 4U);
  EXPECT_THAT(windows_of(record, 4),
              ElementsAre(Pair(0, 0), Pair(100, 5), Pair(200, 12), Pair(300, 16)));
  EXPECT_EQ(window_of(record, 10, 0.5), 5U);
  EXPECT_THAT(windows_of(record, 5), ElementsAre(Pair(0, 0), Pair(100, 5), Pair(300, 16)));
}

/// Blocks of 1 s at 10 Hz; the second snapshot follows the first one after 0.5 s of signal.
TEST(Snapshots, HaveTheSpeedOfTheirOwnSamples) {
  signal::Record record = record_of({5, 10});
  record.snapshot_interval_s = 100;
  const auto speeds = [&] {
    std::vector<std::optional<double>> all;
    for_each_window(record, 10, 5, [&](const TimedWindow& w) { all.push_back(w.speed_rpm); });
    return all;
  };
  EXPECT_THAT(speeds(), ElementsAre(std::nullopt, std::nullopt));
  record.speeds = signal::SpeedCourse{.block_s = 0.5, .rpm = {1000, 1100, 1200}};
  EXPECT_THAT(speeds(), ElementsAre(1000.0, 1100.0));
}

TEST(Snapshots, WithoutAnIntervalContinueEachOther) {
  const signal::Record record = record_of({25, 5, 20});
  EXPECT_EQ(window_of(record, 10, 0), 10U);
  EXPECT_THAT(windows_of(record, 10),
              ElementsAre(Pair(0, 0), Pair(1, 10), Pair(3, 30), Pair(4, 40)));
}

TEST(Snapshots, ShorterThanAWindowAreRefused) {
  signal::Record record = record_of({5, 7});
  record.snapshot_interval_s = 100;
  EXPECT_ERROR(window_of(record, 10, 0.8), Exit::bad_input,
               "longest piece has 7 samples, but a window has 8");
  EXPECT_ERROR(window_of(record_of({9}), 10, 0), Exit::bad_input, "--window-s");
}

TEST(Snapshots, AreOfTheNamedRecord) {
  signal::Recordings recordings;
  recordings.records = {record_of({5})};
  EXPECT_EQ(record_called(recordings, "").name, "run");
  EXPECT_EQ(record_called(recordings, "run").name, "run");
  recordings.records.push_back(record_of({6}));
  recordings.records.back().name = "other";
  EXPECT_EQ(record_called(recordings, "other").signal.size(), 6U);
  EXPECT_ERROR(record_called(recordings, ""), Exit::bad_input, "--record: run, other");
  EXPECT_ERROR(record_called(recordings, "third"), Exit::bad_input,
               "does not have a record third; known: run, other");
}

}  // namespace
}  // namespace piae::trend

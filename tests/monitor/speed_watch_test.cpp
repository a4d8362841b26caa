#include "monitor/speed_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/turning_shaft.hpp"

namespace piae::monitor {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double watched_hz = 4000;
constexpr std::size_t ten_seconds = 40000;

/// Returns stretches of 10 s: the shaft turns at these speeds, or does not show if 0.
std::vector<double> stretches(const std::vector<double>& speeds_rpm) {
  std::vector<double> signal;
  unsigned seed = 0;
  for (const double rpm : speeds_rpm) {
    std::vector<double> stretch = turning_shaft(rpm, ten_seconds, watched_hz, ++seed);
    if (rpm == 0) {
      std::mt19937 random(seed);
      for (double& sample : stretch) sample = std::normal_distribution<double>()(random);
    }
    signal.insert(signal.end(), stretch.begin(), stretch.end());
  }
  return signal;
}

class SpeedOfStream : public testing::Test {
 protected:
  SpeedWatch watch(double percent, std::function<bool(double)> fits = {}) {
    return {watched_hz,
            {.given_rpm = 1200,
             .percent = percent,
             .fits = std::move(fits),
             .say = [this](const std::string& line) { lines_.push_back(line); }},
            "raw"};
  }
  std::vector<std::string> lines_;
};

TEST_F(SpeedOfStream, IsShownByTwoBlocks) {
  SpeedWatch watch = this->watch(10);
  watch.add(stretches({0, 1272, 1272, 0, 1160, 1272, 1160, 1160}));
  EXPECT_EQ(watch.rpm_at(29.9), 1200);
  EXPECT_NEAR(watch.rpm_at(30), 1272, 2);
  EXPECT_NEAR(watch.rpm_at(79.9), 1272, 2);
  EXPECT_NEAR(watch.rpm_at(80), 1160, 2);
  EXPECT_THAT(lines_,
              ElementsAre("raw: the shaft seems to turn at 1272 rpm, 6.0 % above 1200 rpm; this "
                          "speed is used from 30 s on",
                          "raw: the shaft seems to turn at 1160 rpm, 3.4 % below 1200 rpm; this "
                          "speed is used from 80 s on"));
}

TEST_F(SpeedOfStream, IsReportedOnceIfItIsNotUsed) {
  SpeedWatch watch = this->watch(0);
  watch.add(stretches({1272, 1272, 1272, 1272, 0, 0, 1160, 1160}));
  EXPECT_EQ(watch.rpm_at(80), 1200);
  EXPECT_THAT(lines_, ElementsAre("raw: the shaft seems to turn at 1272 rpm, 6.0 % above 1200 rpm; "
                                  "--speed-search-percent takes the speed from the signal"));
}

TEST_F(SpeedOfStream, IsTheGivenOneBeyondTheRange) {
  SpeedWatch narrow = watch(5);
  SpeedWatch unfitting = watch(10, [](double rpm) { return rpm < 1250; });
  for (SpeedWatch* const watch : {&narrow, &unfitting}) {
    lines_.clear();
    watch->add(stretches({1272, 1272}));
    EXPECT_EQ(watch->rpm_at(20), 1200);
    EXPECT_THAT(lines_, ElementsAre("raw: the shaft seems to turn at 1272 rpm, 6.0 % above 1200 "
                                    "rpm; the given speed is used"));
  }
}

TEST_F(SpeedOfStream, IsSilentAboutTheGivenSpeedAndNoise) {
  SpeedWatch given = watch(10);
  given.add(stretches({1204, 1204, 1204}));
  EXPECT_NEAR(given.rpm_at(20), 1204, 1);
  SpeedWatch noise = watch(10);
  noise.add(stretches(std::vector<double>(20, 0.0)));
  EXPECT_EQ(noise.rpm_at(200), 1200);
  EXPECT_THAT(lines_, IsEmpty());
}

TEST_F(SpeedOfStream, DoesNotDependOnPieces) {
  const std::vector<double> signal = stretches({1272, 1272, 1160, 1160});
  std::vector<double> expected;
  for (const std::size_t piece : {160000U, 1000U, 39999U, 7U}) {
    SpeedWatch watch = this->watch(10);
    for (std::size_t at = 0; at < signal.size(); at += piece) {
      watch.add(std::span(signal).subspan(at, std::min(piece, signal.size() - at)));
    }
    const std::vector<double> found{watch.rpm_at(19), watch.rpm_at(21), watch.rpm_at(41)};
    if (expected.empty()) expected = found;
    EXPECT_EQ(found, expected) << piece;
  }
}

/// After 5 s of signal and a gap of 2 s, blocks end at 17 and 27 s.
TEST_F(SpeedOfStream, DoesNotSpanGaps) {
  const std::vector<double> signal = stretches({1272, 1272, 1272});
  SpeedWatch watch = this->watch(10);
  watch.add(std::span(signal).first(20000));
  watch.restart(7);
  watch.add(std::span(signal).subspan(20000, 80000));
  EXPECT_EQ(watch.rpm_at(26.9), 1200);
  EXPECT_NEAR(watch.rpm_at(27), 1272, 2);
}

TEST_F(SpeedOfStream, IsNotSearchedWithoutAGivenOne) {
  SpeedWatch watch(watched_hz, {.percent = 10}, "raw");
  watch.add(stretches({1272, 1272}));
  EXPECT_EQ(watch.rpm_at(20), 0);
}

}  // namespace
}  // namespace piae::monitor

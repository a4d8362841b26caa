#include "trend/features.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/errors.hpp"
#include "trend/healthy_hours.hpp"

namespace piae::trend {
namespace {

using testing::ElementsAre;

/// PRONOSTIA's bearing. Its orders: 13 / 2 (1 -+ 3.5 / 25.6), and 25.6 / 3.5 (1 - (3.5 / 25.6)^2).
const bearing::Geometry nskb{.balls = 13,
                             .ball_diameter_mm = 3.5,
                             .pitch_diameter_mm = 25.6,
                             .inner_raceway_mm = 22.1,
                             .outer_raceway_mm = 29.1};

TEST(Features, AreNamed) {
  EXPECT_THAT(noise_meter().names(), ElementsAre("0-12.5 Hz", "12.5-25 Hz", "25-50 Hz", "50-100 Hz",
                                                 "100-200 Hz", "200-400 Hz", "peak"));
  const FeatureMeter meter(25600, 2560, lines_shown(nskb, 1800, 25600, 2560));
  EXPECT_THAT(meter.names(),
              ElementsAre("0-312 Hz", "312-625 Hz", "625-1250 Hz", "1250-2500 Hz", "2500-5000 Hz",
                          "5000-10000 Hz", "peak", "inner line", "roller line", "outer line"));
}

TEST(Features, KnowLinesThatWindowsCanSeparate) {
  const auto lines = lines_shown(nskb, 1800, 25600, 2560);
  ASSERT_TRUE(lines.has_value());
  EXPECT_NEAR(lines->orders[0], 7.388672, 1e-6);
  EXPECT_NEAR(lines->orders[1], 7.177567, 1e-6);
  EXPECT_NEAR(lines->orders[2], 5.611328, 1e-6);
  // Two bins at the fourth harmonic: 4 * 0.211105 * 30 Hz * length / 25600 Hz >= 2
  EXPECT_TRUE(lines_shown(nskb, 1800, 25600, 2022).has_value());
  EXPECT_FALSE(lines_shown(nskb, 1800, 25600, 2021).has_value());
  EXPECT_FALSE(lines_shown(nskb, 1800, 1700, 100000).has_value());  // no band for the envelope
}

// A sine of amplitude 3 about 5: RMS^2 = 4.5, peak 3.
TEST(Features, MeasureLevelAndPeakAboutTheMean) {
  std::vector<float> window(noise_length);
  for (std::size_t i = 0; i < window.size(); ++i) {
    const double angle = 2 * std::numbers::pi * 40 * static_cast<double>(i) / noise_length;
    window[i] = static_cast<float>(5 + 3 * std::sin(angle));
  }
  const Features features = noise_meter().measure(window);
  EXPECT_NEAR(features.level_db, 10 * std::log10(4.5), 1e-5);
  EXPECT_NEAR(features.watched_db[octaves], 20 * std::log10(3), 0.05);
  EXPECT_EQ(features.watched_db.size(), 7);
  EXPECT_EQ(features.shape_db.size(), 48);
}

// Ten times the amplitude raises all levels by 20 dB and does not change the shape.
TEST(Features, RiseWithTheAmplitude) {
  Stream random("features");
  std::vector<float> window = noise_window(random);
  const Features before = noise_meter().measure(window);
  for (float& x : window) x *= 10;
  const Features after = noise_meter().measure(window);
  EXPECT_NEAR(after.level_db - before.level_db, 20, 1e-4);
  EXPECT_NEAR((after.watched_db - before.watched_db).minCoeff(), 20, 1e-4);
  EXPECT_NEAR((after.watched_db - before.watched_db).maxCoeff(), 20, 1e-4);
  EXPECT_NEAR((after.shape_db - before.shape_db).abs().maxCoeff(), 0, 1e-4);
}

/// Returns the rise of the lines by bursts of 3 kHz at the order of the outer race at 1800 rpm.
Eigen::ArrayXd rise_by_impacts_db(const FeatureMeter& meter, std::optional<double> speed_rpm) {
  Stream random("impacts");
  std::vector<float> healthy(2560);
  std::vector<float> faulty(2560);
  const double period_s = 1 / (5.611328 * 30);
  for (std::size_t i = 0; i < healthy.size(); ++i) {
    const double since_s = std::fmod(static_cast<double>(i) / 25600, period_s);
    healthy[i] = static_cast<float>(random.normal(0, 0.2));
    faulty[i] = healthy[i] + static_cast<float>(3 * std::exp(-since_s * 2000) *
                                                std::sin(2 * std::numbers::pi * 3000 * since_s));
  }
  return meter.measure(faulty, speed_rpm).watched_db.tail(3) -
         meter.measure(healthy, speed_rpm).watched_db.tail(3);
}

TEST(Features, ShowTheLineOfImpacts) {
  const FeatureMeter meter(25600, 2560, lines_shown(nskb, 1800, 25600, 2560));
  Eigen::Index highest = 0;
  EXPECT_GT(rise_by_impacts_db(meter, std::nullopt).maxCoeff(&highest), 6);
  EXPECT_EQ(highest, 2);
}

TEST(Features, ShowTheLineAtTheSpeedOfTheWindow) {
  const FeatureMeter meter(25600, 2560, lines_shown(nskb, 1600, 25600, 2560));
  EXPECT_LT(rise_by_impacts_db(meter, std::nullopt)[2], 3);
  const FeatureMeter of_right_speed(25600, 2560, lines_shown(nskb, 1800, 25600, 2560));
  EXPECT_EQ(rise_by_impacts_db(meter, 1800)[2], rise_by_impacts_db(of_right_speed, {})[2]);
}

}  // namespace
}  // namespace piae::trend

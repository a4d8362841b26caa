#include "symptoms/measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/computed_window.hpp"
#include "support/errors.hpp"
#include "support/impact_windows.hpp"

namespace piae::symptoms {
namespace {

// n/2 (1 + d/D), D/d (1 - (d/D)^2), n/2 (1 - d/D) with n = 9, d = 7.94 and D = 39.
TEST(LineOrders, MatchA6205) {
  const auto orders = line_orders({});
  EXPECT_NEAR(orders[0], 5.416154, 1e-6);
  EXPECT_NEAR(orders[1], 4.708249, 1e-6);
  EXPECT_NEAR(orders[2], 3.583846, 1e-6);
}

signal::WindowSet computed_set() {
  signal::WindowSet set = no_impact_windows(2048);
  set.samples = computed_window();
  set.labels = {0};
  return set;
}

TEST(Measures, MatchNumpy) {
  const Measures measures = measure(computed_set(), "--test").front();
  const double heights[3][4] = {{-0.376805, 0.267501, 0.072102, 0.226036},
                                {-0.133092, -0.109131, 0.174958, 0.082016},
                                {1.057183, 1.060267, 1.017147, 0.994209}};
  for (std::size_t fault_type = 0; fault_type < 3; ++fault_type) {
    for (std::size_t n = 0; n < 4; ++n) {
      EXPECT_NEAR(measures.heights.at(fault_type).at(n), heights[fault_type][n], 2e-6)
          << fault_type << " " << n;
    }
  }
  EXPECT_NEAR(measures.lines[0], 0.226036, 2e-6);
  EXPECT_NEAR(measures.lines[2], 0.994209, 2e-6);
  EXPECT_NEAR(measures.log_kurtosis, 2.038755, 1e-6);
  EXPECT_NEAR(measures.shape_db[23], 12.34234, 2e-5);
  EXPECT_NEAR(measures.levels_db[3], -1.50457, 2e-5);
}

TEST(Measures, IgnoreLevelAndOffset) {
  signal::WindowSet louder = computed_set();
  for (float& sample : louder.samples) sample = 8 * sample + 2;
  const Measures measures = measure(louder, "--test").front();
  EXPECT_NEAR(measures.heights[2][3], 0.994209, 1e-4);
  EXPECT_NEAR(measures.log_kurtosis, 2.038755, 1e-4);
  EXPECT_NEAR(measures.levels_db[3], -1.50457, 1e-3);
}

TEST(Measures, ShowTheLineOfTheDefectiveElement) {
  Stream stream("struck");
  signal::WindowSet set = no_impact_windows();
  for (const Label label : {0, 1, 2}) add_impact_windows(set, label, 5, stream);
  const std::vector<Measures> all = measure(set, "--test");
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_LT(*std::ranges::max_element(all[i].lines), 0.5) << i;
    EXPECT_GT(all[5 + i].lines[0], 0.8) << i;  // inner
    EXPECT_LT(all[5 + i].lines[2], 0.5) << i;
    EXPECT_GT(all[10 + i].lines[2], 0.8) << i;  // outer
    EXPECT_LT(all[10 + i].lines[0], 0.5) << i;
  }
}

// At half the speed the impacts of the same window are at twice the order.
TEST(Measures, UseTheSpeedOfTheWindow) {
  signal::WindowSet set = computed_set();
  set.condition = {0};
  set.shaft_speed_rpm = {900};
  EXPECT_LT(measure(set, "--test").front().heights[2][0], 0.5);
}

TEST(Measures, WorkAtOtherRates) {
  Stream stream("struck");
  signal::WindowSet set = no_impact_windows(8192);
  set.info.sample_rate_hz = 25600;
  set.samples = impact_window(
      {.length = 8192, .rate_hz = 25600, .impacts_hz = impacts_of_classes_hz[2]}, stream);
  set.labels = {2};
  const Measures measures = measure(set, "--test").front();
  EXPECT_GT(measures.lines[2], 0.8);
  // two harmonics of the lines lie close together
  EXPECT_GT(measures.lines[2], measures.lines[0] + 0.3);
  EXPECT_EQ(measures.shape_db.size(), 48);
}

// 2BSF and BPFI of a 6205 lie 0.7079 orders apart, their fourth harmonics 2.8316: two bins are
// 0.7063 turns, which at 600 rpm and 12 kHz are 847.6 samples.
TEST(Measures, NeedWindowsLongEnoughToSeparateTheLines) {
  Stream stream("noise");
  for (const auto& [length, enough] : {std::pair(848, true), std::pair(847, false)}) {
    signal::WindowSet set = no_impact_windows(static_cast<std::size_t>(length));
    set.info.shaft_speed_rpm = 600;
    add_impact_windows(set, 0, 1, stream);
    if (enough) {
      EXPECT_EQ(measure(set, "--test").size(), 1U);
    } else {
      EXPECT_ERROR(measure(set, "--test"), Exit::bad_input,
                   "--test: windows of 847 samples are too short to tell the fault lines apart at "
                   "600 rpm; use 848 or more");
    }
  }
}

// Nine balls of 2/7 of the pitch diameter spin at the frequency at which they pass the outer race.
TEST(Measures, NeedLinesThatDoNotCoincide) {
  signal::WindowSet set = computed_set();
  set.info.bearing = {.balls = 9,
                      .ball_diameter_mm = 2.0 / 7 * 39,
                      .pitch_diameter_mm = 39,
                      .inner_raceway_mm = 27,
                      .outer_raceway_mm = 51};
  EXPECT_ERROR(measure(set, "--test"), Exit::bad_input,
               "--test: the fault lines of two fault types coincide in this bearing");
}

TEST(Measures, NeedAPossibleSpeedRateAndBearing) {
  signal::WindowSet set = computed_set();
  set.info.shaft_speed_rpm = 0;
  EXPECT_ERROR(measure(set, "--test"), Exit::bad_input, "--test: the shaft speed is 0 rpm");
  set.info.shaft_speed_rpm = 60000;
  EXPECT_ERROR(measure(set, "--test"), Exit::bad_input, "at 60000 rpm fault lines reach 21925 Hz");
  set = computed_set();
  set.info.sample_rate_hz = 1500;
  EXPECT_ERROR(measure(set, "--test"), Exit::bad_input, "sample rate of 1500 Hz is too low");
  set = computed_set();
  set.info.bearing.balls = 0;
  EXPECT_ERROR(measure(set, "--test"), Exit::bad_input, "0 balls");
  set = computed_set();
  std::ranges::fill(set.samples, 1.0F);
  EXPECT_ERROR(measure(set, "--test"), Exit::bad_input, "--test: window 0 is constant");
}

}  // namespace
}  // namespace piae::symptoms

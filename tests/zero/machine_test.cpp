#include "zero/machine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "support/errors.hpp"
#include "zero/healthy.hpp"

namespace piae::zero {
namespace {

/// Returns the same windows, three in each of two conditions.
signal::WindowSet at_two_speeds() {
  signal::WindowSet healthy = healthy_windows();
  healthy.info.conditions = {{.name = "900 rpm", .shaft_speed_rpm = 900},
                             {.name = "1800 rpm", .shaft_speed_rpm = 1800}};
  healthy.condition = {0, 0, 0, 1, 1, 1};
  healthy.shaft_speed_rpm = {900, 901, 902, 1800, 1801, 1802};
  return healthy;
}

TEST(Machine, CyclesThroughConditionsAtTheSpeedOfTheHealthyWindow) {
  const signal::WindowSet healthy = at_two_speeds();
  const Machine machine(healthy);
  std::set<double> speeds;
  for (std::size_t i = 0; i < 200; ++i) {
    Stream random("scene " + std::to_string(i));
    const Scene scene = machine.draw_scene(2, i, random);
    ASSERT_EQ(scene.condition, static_cast<std::int32_t>(i % 2));
    // A 6205 has 3.5848 impacts per turn on its outer race: 4.5 (1 - 7.94 / 39).
    ASSERT_NEAR(scene.impact_frequency_hz / (scene.shaft_speed_rpm / 60), 4.5 * (1 - 7.94 / 39),
                1e-9);
    EXPECT_EQ(scene.defect, bearing::Defect::outer);
    speeds.insert(scene.shaft_speed_rpm);
  }
  EXPECT_EQ(speeds, (std::set<double>{900, 901, 902, 1800, 1801, 1802}));
}

TEST(Machine, UsesHealthyWindowsOfItsSpeed) {
  signal::WindowSet healthy = at_two_speeds();
  healthy.condition.assign(6, signal::every_condition);
  const Machine machine(healthy);
  for (std::size_t i = 0; i < 50; ++i) {
    Stream random("scene " + std::to_string(i));
    EXPECT_NEAR(machine.draw_scene(1, i, random).shaft_speed_rpm, i % 2 == 0 ? 901 : 1801, 1);
  }
  // If no window has the tested speed, the nearest ones are used: a loaded machine turns a little
  // slower.
  healthy.info.conditions[0].shaft_speed_rpm = 1700;
  const Machine loaded(healthy);
  Stream random("scene");
  EXPECT_NEAR(loaded.draw_scene(1, 0, random).shaft_speed_rpm, 1801, 1);
}

TEST(Machine, NeedsHealthyWindowsOfEachTestedCondition) {
  signal::WindowSet healthy = at_two_speeds();
  healthy.condition = {0, 0, 0, 0, 0, 0};
  EXPECT_ERROR(Machine{healthy}, Exit::bad_input, "tested condition '1800 rpm'");
  healthy.condition = {0, 0, 0, signal::every_condition, 0, 0};
  EXPECT_NO_THROW(Machine{healthy});
  healthy.info.conditions[1].test = false;
  healthy.condition = {0, 0, 0, 0, 0, 0};
  EXPECT_NO_THROW(Machine{healthy});
  const signal::WindowSet none = healthy_windows(1024, 0);
  EXPECT_ERROR(Machine{none}, Exit::bad_input, "no healthy window");
}

TEST(Machine, NeedsAPossibleBearingAndSpeed) {
  signal::WindowSet healthy = healthy_windows();
  healthy.info.bearing.balls = 0;
  EXPECT_ERROR(Machine{healthy}, Exit::bad_input, "bearing: 0 balls");
  healthy = healthy_windows();
  for (const double unknown : {0.0, std::numeric_limits<double>::quiet_NaN()}) {
    healthy.info.shaft_speed_rpm = unknown;
    EXPECT_ERROR(Machine{healthy}, Exit::bad_input, "describe the speed");
  }
}

TEST(Machine, NeedsASampleRateThatSeparatesImpacts) {
  signal::WindowSet healthy = healthy_windows();
  // At 1800 rpm, BPFI is 162.5 Hz and 2 BSF 141.4 Hz.
  healthy.info.sample_rate_hz = 320;
  EXPECT_ERROR(Machine{healthy}, Exit::bad_input, "class IR has 162.485 impacts per second");
}

TEST(Machine, NeedsWindowsLongEnoughForAnImpact) {
  // At 1800 rpm, BPFO is 107.5 Hz: one impact in 111.6 samples.
  const signal::WindowSet shorter = healthy_windows(111);
  EXPECT_ERROR(Machine{shorter}, Exit::bad_input,
               "class OR has 107.515 impacts per second at 1800 rpm, so windows of 111 "
               "samples may miss them; use 112 samples or more");
  const signal::WindowSet just_long_enough = healthy_windows(112);
  EXPECT_NO_THROW(Machine{just_long_enough});
  // A slower shaft needs longer windows.
  signal::WindowSet slower = at_two_speeds();
  slower.shaft_speed_rpm[0] = 190;
  EXPECT_ERROR(Machine{slower}, Exit::bad_input, "at 190 rpm, so windows of 1024 samples");
}

/// Returns the ripple of a healthy machine's spectrum if each of its windows of 8192 samples
/// contains an echo, half as strong, after `lag` samples. The logarithm of |1 + exp(-i w lag) / 2|
/// is cos(w lag) / 2 minus cos(2 w lag) / 8 and so on.
double ripple_of_echo(std::size_t lag) {
  signal::WindowSet healthy = healthy_windows(8192);
  const std::vector<float> direct = healthy.samples;
  for (std::size_t i = 0; i < direct.size(); ++i) {
    const std::size_t window = i / 8192 * 8192;
    healthy.samples[i] += direct[window + (i + 8192 - lag) % 8192] / 2;
  }
  const Machine machine(healthy);
  const Eigen::ArrayXd& spectrum = machine.log_amplitude(signal::every_condition);
  EXPECT_EQ(spectrum.size(), 8193);
  double ripple = 0;
  for (Eigen::Index bin = 0; bin < spectrum.size(); ++bin) {
    const double rad_per_sample = std::numbers::pi * static_cast<double>(bin) / 8192;
    ripple += spectrum[bin] * std::cos(rad_per_sample * static_cast<double>(lag));
  }
  return 2 * ripple / 8193;
}

TEST(Machine, KeepsTheColourButNotTheLines) {
  // Ripples up to 0.7 x 256 samples are kept, and half of a ripple of 217.6 samples.
  EXPECT_NEAR(ripple_of_echo(32), 0.5, 0.05);
  EXPECT_NEAR(ripple_of_echo(170), 0.5, 0.05);
  EXPECT_NEAR(ripple_of_echo(218), 0.25, 0.05);
  EXPECT_NEAR(ripple_of_echo(270), 0, 1e-3);
}

}  // namespace
}  // namespace piae::zero

#include "machines/healthy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "machines/plain_machine.hpp"

namespace piae::machines {
namespace {

double mean_power(const signal::WindowSet& set) {
  double sum = 0;
  for (std::size_t i = 0; i < set.size(); ++i) sum += power_of(set, i);
  return sum / static_cast<double>(set.size());
}

double mean_sine(const signal::WindowSet& set, double hz, bool squared = false) {
  double sum = 0;
  for (std::size_t i = 0; i < set.size(); ++i) sum += sine_in(set, i, hz, squared);
  return sum / static_cast<double>(set.size());
}

TEST(HealthyWindows, HaveTheLabelOfHealthyAndDifferFromEachOther) {
  const Machine machine = plain_machine();
  const signal::WindowSet set = healthy_windows(machine, 3, Day::of_reference, Stream("h"));
  EXPECT_EQ(set.labels, (std::vector<Label>{0, 0, 0}));
  EXPECT_EQ(set.samples.size(), 3U * 4096);
  EXPECT_NE(set.window(0)[0], set.window(1)[0]);
  const signal::WindowSet fewer = healthy_windows(machine, 2, Day::of_reference, Stream("h"));
  EXPECT_EQ(fewer.window(1)[7], set.window(1)[7]);
}

TEST(HealthyWindows, HaveTonesAndSensorNoiseOfTheStatedPower) {
  Machine machine = plain_machine();
  machine.sensor_noise = 0.5;
  machine.tones = {{.hz = 30, .amplitude = 5, .of_shaft = true}};
  machine.tone_power = 2;
  const signal::WindowSet set = healthy_windows(machine, 20, Day::of_reference, Stream("h"));
  // 1 of the noise, 2 of the tone, 0.25 of the sensor; levels scatter by 10 %.
  EXPECT_NEAR(mean_power(set), 3.25, 0.25);
  EXPECT_NEAR(mean_sine(set, 30), 2, 0.15);
}

TEST(HealthyWindows, FollowTheSpectrumOfTheMachine) {
  Machine machine = plain_machine();
  machine.log_amplitude.head(2048) += std::log(4.0);  // below 3 kHz, in bins of 12000 / 8192 Hz
  const signal::WindowSet set = healthy_windows(machine, 30, Day::of_reference, Stream("h"));
  double low = 0;
  double high = 0;
  for (double hz = 400; hz < 2700; hz += 100) {
    low += mean_sine(set, hz);
    high += mean_sine(set, hz + 3000);
  }
  EXPECT_NEAR(low / high, 4, 0.3);
}

TEST(HealthyWindows, AreModulatedAtTheShaft) {
  Machine machine = plain_machine();
  machine.modulation = {0, 0, 0, 0.3};
  const signal::WindowSet set = healthy_windows(machine, 30, Day::of_reference, Stream("h"));
  // (1 + 0.3 cos)^2 of white noise of power 1 / (1 + 0.3^2 / 2): a sine of 0.6 / 1.045.
  EXPECT_NEAR(mean_sine(set, 30, true), 0.574, 0.06);
  EXPECT_LT(mean_sine(set, 47, true), 0.1);
}

TEST(HealthyWindows, HaveAnotherPathOnAnotherDay) {
  Machine machine = plain_machine();
  machine.day_db = 6;
  const auto slope = [&](Day day) {
    const signal::WindowSet set = healthy_windows(machine, 30, day, Stream("h"));
    double away = 0;
    double before = mean_sine(set, 400);
    for (double hz = 800; hz < 5700; hz += 400) {
      const double here = mean_sine(set, hz);
      away += std::abs(std::log(here / before));
      before = here;
    }
    return away;
  };
  EXPECT_GT(slope(Day::other), 1.7 * slope(Day::of_reference));
}

}  // namespace
}  // namespace piae::machines

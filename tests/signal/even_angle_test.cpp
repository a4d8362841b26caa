#include "signal/even_angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/drifting_shaft.hpp"

namespace piae::signal {
namespace {

/// Two turns a second, then four: the first half of the turns takes two thirds of the time.
TEST(EvenAngle, StretchesFastStretches) {
  std::vector<double> signal(300);
  for (std::size_t i = 0; i < signal.size(); ++i) signal[i] = static_cast<double>(i);
  const std::vector<double> even =
      at_even_angle(signal, 100, {.block_s = 1, .rpm = {120, 120, 240}});
  ASSERT_EQ(even.size(), 300U);
  EXPECT_NEAR(even[0], 0, 1e-9);
  EXPECT_NEAR(even[75], 100, 1e-9);   // 2 of 8 turns
  EXPECT_NEAR(even[150], 200, 1e-9);  // 4 of 8 turns
  EXPECT_NEAR(even[225], 250, 1e-9);  // 6 of 8 turns
}

/// The third harmonic of a shaft whose speed drifts by 20 % becomes a steady tone.
TEST(EvenAngle, MakesHarmonicsSteady) {
  const DriftingShaft shaft{.mean_rpm = 600, .drift = 0.2, .duration_s = 10};
  constexpr double rate_hz = 4000;
  const auto turns_at = [&](double time_s) {
    return time_s * (shaft.rpm_at(0) + shaft.rpm_at(time_s)) / 2 / 60;
  };
  ShaftAngle angle;
  for (int i = 0; i <= 1000; ++i) {
    angle.time_s.push_back(0.01 * i);
    angle.turns.push_back(turns_at(0.01 * i));
  }
  std::vector<double> signal(40000);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    signal[i] = std::sin(6 * std::numbers::pi * turns_at(static_cast<double>(i) / rate_hz));
  }
  const std::vector<double> even = at_even_angle(signal, rate_hz, speed_course(angle, 10, 0));
  for (std::size_t i = 0; i < even.size(); ++i) {
    const double turns = 10.0 * static_cast<double>(i) / rate_hz;
    ASSERT_NEAR(even[i], std::sin(6 * std::numbers::pi * turns), 0.01) << i;
  }
}

}  // namespace
}  // namespace piae::signal

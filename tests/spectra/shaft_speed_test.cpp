// Speed of a shaft from its vibration.

#include "spectra/shaft_speed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "support/turning_shaft.hpp"

namespace piae::spectra {
namespace {

constexpr double rate_of_shaft_hz = 12000;
constexpr std::size_t ten_s = 120000;

std::vector<double> white_noise(std::size_t samples, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> signal(samples);
  for (double& sample : signal) sample = normal(random);
  return signal;
}

TEST(ShaftSpeed, IsFoundByItsHarmonics) {
  for (const double rpm : {1265.0, 1400.0, 1477.0, 1535.0}) {
    const std::vector<double> signal = turning_shaft(rpm, ten_s, rate_of_shaft_hz);
    const auto speed = estimate_shaft_speed(signal, rate_of_shaft_hz, 1400);
    ASSERT_TRUE(speed);
    EXPECT_NEAR(speed->rpm / rpm, 1, 5e-4);
    EXPECT_TRUE(speed->is_certain()) << speed->confidence;
  }
}

/// Adds harmonics of the mains, higher than those of the shaft.
void add_hum(double mains_hz, std::vector<double>& signal) {
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const double turn = 2 * std::numbers::pi * mains_hz * static_cast<double>(i) / rate_of_shaft_hz;
    for (int n = 1; n <= 12; ++n) signal[i] += 0.1 / std::sqrt(n) * std::sin(n * turn);
  }
}

// A motor of two poles turns a little slower than the mains.
TEST(ShaftSpeed, IsNotThatOfTheMains) {
  for (const double mains_hz : {50.0, 60.0}) {
    const double rpm = 60 * mains_hz * 2950 / 3000;
    std::vector<double> signal = turning_shaft(rpm, ten_s, rate_of_shaft_hz);
    add_hum(mains_hz, signal);
    const auto speed = estimate_shaft_speed(signal, rate_of_shaft_hz, rpm);
    ASSERT_TRUE(speed);
    EXPECT_FALSE(speed->is_certain()) << speed->rpm;  // the hum is higher
    const auto without =
        estimate_shaft_speed(turning_shaft(rpm, ten_s, rate_of_shaft_hz), rate_of_shaft_hz, rpm);
    ASSERT_TRUE(without);
    EXPECT_TRUE(without->is_certain());
    EXPECT_NEAR(without->rpm / rpm, 1, 5e-4);
  }
}

/// Noise of twice the amplitude during a tenth of each turn: only the envelope shows the speed.
TEST(ShaftSpeed, IsFoundByTheEnvelopeAlone) {
  std::vector<double> signal = white_noise(ten_s);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const double turn = 1477.0 / 60 * static_cast<double>(i) / rate_of_shaft_hz;
    if (turn - std::floor(turn) < 0.1) signal[i] *= 2;
  }
  const auto speed = estimate_shaft_speed(signal, rate_of_shaft_hz, 1400);
  ASSERT_TRUE(speed);
  EXPECT_NEAR(speed->rpm / 1477, 1, 1e-3);
  EXPECT_TRUE(speed->is_certain()) << speed->confidence;
}

/// Impacts at 108 Hz are four times a speed of 1620 rpm and six times one of 1080 rpm, which no
/// shaft shows.
TEST(ShaftSpeed, IsNotAFractionOfAnImpactRate) {
  for (const double nominal_rpm : {1650.0, 1100.0}) {
    std::vector<double> signal = white_noise(ten_s);
    for (std::size_t i = 0; i < signal.size(); ++i) {
      const double impact = 108.0 * static_cast<double>(i) / rate_of_shaft_hz;
      if (impact - std::floor(impact) < 0.1) signal[i] *= 4;
    }
    const auto speed = estimate_shaft_speed(signal, rate_of_shaft_hz, nominal_rpm);
    ASSERT_TRUE(speed);
    EXPECT_FALSE(speed->is_certain()) << speed->rpm << ' ' << speed->confidence;
  }
}

/// One line at a wrong place, such as mains, does not decide, however high it is.
TEST(ShaftSpeed, IsNotThatOfOneHighLine) {
  std::vector<double> signal = turning_shaft(1477, ten_s, rate_of_shaft_hz);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    signal[i] +=
        100 * std::sin(2 * std::numbers::pi * 50 * static_cast<double>(i) / rate_of_shaft_hz);
  }
  EXPECT_NEAR(estimate_shaft_speed(signal, rate_of_shaft_hz, 1400)->rpm / 1477, 1, 1e-3);
}

TEST(ShaftSpeed, IsUncertainInNoise) {
  int certain = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const auto speed = estimate_shaft_speed(white_noise(ten_s, seed), rate_of_shaft_hz, 1400);
    ASSERT_TRUE(speed);
    EXPECT_NEAR(speed->rpm, 1400, 140.1);
    certain += speed->is_certain() ? 1 : 0;
  }
  EXPECT_LE(certain, 1);
}

TEST(ShaftSpeed, IsWithinSoManyPercentIfItIsCertain) {
  EXPECT_TRUE((ShaftSpeed{1050, 2.5}.is_within(5.1, 1000)));
  EXPECT_FALSE((ShaftSpeed{1050, 2.5}.is_within(4.9, 1000)));
  EXPECT_FALSE((ShaftSpeed{1050, 2.4}.is_within(5.1, 1000)));
  EXPECT_FALSE((ShaftSpeed{1050, 9}.is_within(0, 1000)));
}

TEST(ShaftSpeed, NeedsTurnsAndHarmonics) {
  const std::vector<double> signal = white_noise(ten_s);
  EXPECT_FALSE(estimate_shaft_speed({}, rate_of_shaft_hz, 1400));
  EXPECT_FALSE(estimate_shaft_speed(std::span(signal).first(10000), rate_of_shaft_hz, 1400));
  EXPECT_TRUE(estimate_shaft_speed(std::span(signal).first(11000), rate_of_shaft_hz, 1400));
  EXPECT_FALSE(estimate_shaft_speed(signal, rate_of_shaft_hz, 120000));
  EXPECT_FALSE(estimate_shaft_speed(std::vector<double>(ten_s, 1.5), rate_of_shaft_hz, 1400));
}

}  // namespace
}  // namespace piae::spectra

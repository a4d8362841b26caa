#include "diagnosis/log_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.hpp"

namespace piae::diagnosis {
namespace {

using Eigen::Index;

scoring::Windows sine(Index length, double cycles, double amplitude) {
  scoring::Windows window(1, length);
  for (Index t = 0; t < length; ++t) {
    const double turns = cycles * static_cast<double>(t) / static_cast<double>(length);
    window(0, t) = 7 + amplitude * std::sin(2 * std::numbers::pi * turns + 1);
  }
  return window;
}

// Bands are half a cycle per window apart, starting at half a cycle: 100 cycles are band 199.
TEST(LogSpectrum, SineShowsItsAmplitudeAtItsFrequency) {
  const Eigen::ArrayXd bands = log_spectrum(sine(1024, 100, 0.25), 1024, 1e-9);
  ASSERT_EQ(bands.size(), 1024);
  Index highest = 0;
  EXPECT_NEAR(bands.maxCoeff(&highest), std::log(0.25), 1e-9);
  EXPECT_EQ(highest, 199);
  // Hann's window: half of the amplitude one cycle from the line, nothing two cycles from it.
  EXPECT_NEAR(bands[201], std::log(0.125), 1e-9);
  EXPECT_NEAR(bands[203], std::log(1e-9), 1e-9);
}

TEST(LogSpectrum, HasAtLeastTheRequestedBands) {
  EXPECT_EQ(log_spectrum(sine(1024, 100, 1), 512, 1e-9).size(), 512);
  EXPECT_EQ(log_spectrum(sine(512, 100, 1), 1024, 1e-9).size(), 1024);
  EXPECT_EQ(log_spectrum(sine(8192, 100, 1), 8192, 1e-9).size(), 8192);
  EXPECT_EQ(log_spectrum(sine(1000, 100, 1), 1024, 1e-9).size(), 1500);
  // Without padding a band is one cycle per window.
  Index highest = 0;
  EXPECT_NEAR(log_spectrum(sine(1024, 100, 1), 512, 1e-9).maxCoeff(&highest), 0, 1e-9);
  EXPECT_EQ(highest, 99);
}

// Parseval: the sum of the powers of all frequencies, negative ones and 0 included, is the energy
// of the tapered window times the length of the transform.
TEST(LogSpectrum, HoldsTheEnergyOfTheTaperedWindow) {
  constexpr Index length = 1024;
  Stream stream("parseval");
  scoring::Windows window(1, length);
  for (Index t = 0; t < length; ++t) window(0, t) = stream.normal(3, 2);
  double energy = 0;
  double sum = 0;
  for (Index t = 0; t < length; ++t) {
    const double hann = std::pow(std::sin(std::numbers::pi * static_cast<double>(t) / length), 2);
    const double tapered = (window(0, t) - window.mean()) * hann;
    energy += tapered * tapered;
    sum += tapered;
  }
  const Eigen::ArrayXd amplitude = log_spectrum(window, length, 1e-12).exp();
  const Eigen::ArrayXd power = (amplitude * length / 4).square();
  const double last = power[length - 1];  // half the sample rate has no negative counterpart
  EXPECT_NEAR(2 * power.sum() - last + sum * sum, 2 * length * energy, 1e-6 * 2 * length * energy);
}

TEST(LogSpectrum, SilenceGivesTheFloor) {
  const Eigen::ArrayXd bands = log_spectrum(sine(1024, 100, 0), 1024, 0.5);
  EXPECT_EQ(bands.minCoeff(), std::log(0.5));
  EXPECT_EQ(bands.maxCoeff(), std::log(0.5));
}

TEST(RootMeanSquare, RemovesTheMean) {
  EXPECT_NEAR(root_mean_square(sine(1024, 100, 3)), 3 / std::numbers::sqrt2, 1e-12);
}

/// Returns a carrier of 200 cycles and amplitude 2 in 1024 samples, modulated at 12 cycles.
scoring::Windows modulated(double depth) {
  constexpr double cycle = 2 * std::numbers::pi / 1024;
  scoring::Windows window(1, 1024);
  for (Index t = 0; t < 1024; ++t) {
    const auto at = static_cast<double>(t);
    window(0, t) =
        2 * (1 + depth * std::cos(12 * cycle * at)) * std::sin(200 * cycle * at + 1) + 0.5;
  }
  return window;
}

// The carrier has no line; the line of its modulation has the modulation's amplitude.
TEST(LogEnvelopeSpectrum, ShowsTheModulationOfACarrier) {
  const Eigen::ArrayXd bands = log_envelope_spectrum(modulated(0.3), 1024, 1e-6);
  ASSERT_EQ(bands.size(), 1024);
  Index highest = 0;
  EXPECT_NEAR(bands.maxCoeff(&highest), std::log(2 * 0.3), 1e-9);
  EXPECT_EQ(highest, 23);
  EXPECT_NEAR(bands[399], std::log(1e-6), 1e-9);
}

TEST(LogEnvelopeSpectrum, SteadyCarrierGivesTheFloor) {
  const Eigen::ArrayXd bands = log_envelope_spectrum(modulated(0), 512, 1e-6);
  ASSERT_EQ(bands.size(), 512);
  EXPECT_EQ(bands.maxCoeff(), std::log(1e-6));
}

scoring::Windows noise(Index length) {
  Stream stream("noise");
  scoring::Windows window(1, length);
  for (double& sample : window.row(0)) sample = stream.normal(1, 2);
  return window;
}

// The modulation of 12 cycles is the order 12 / turns. Orders are 0.5 apart.
TEST(LogOrderSpectrum, ShowsTheModulationAtItsOrder) {
  for (const double turns : {2.0, 3.0, 8.0}) {
    const Eigen::ArrayXd orders = log_order_spectrum(modulated(0.3), turns, 40, 1e-6);
    ASSERT_EQ(orders.size(), 40);
    Index highest = 0;
    EXPECT_NEAR(orders.maxCoeff(&highest), std::log(2 * 0.3), 1e-9);
    EXPECT_DOUBLE_EQ(0.5 + 0.5 * static_cast<double>(highest), 12 / turns);
  }
}

// At 1.25 turns orders are 0.625 cycles apart: order 9.5 is 11.875 cycles, between 11.5 and 12.
TEST(LogOrderSpectrum, InterpolatesBetweenFrequencies) {
  const Eigen::ArrayXd spectrum = log_envelope_spectrum(modulated(0.3), 1024, 1e-6);
  const Eigen::ArrayXd orders = log_order_spectrum(modulated(0.3), 1.25, 40, 1e-6);
  EXPECT_NEAR(orders[18], 0.25 * spectrum[22] + 0.75 * spectrum[23], 1e-12);
}

// Half a turn has one cycle at order 2, and 200 turns have 512 cycles at order 2.56.
TEST(LogOrderSpectrum, OrdersThatItLacksAreTheMeanOfTheOthers) {
  const Eigen::ArrayXd slow = log_order_spectrum(noise(1024), 0.5, 40, 1e-6);
  const Eigen::ArrayXd fast = log_order_spectrum(noise(1024), 200, 40, 1e-6);
  EXPECT_NEAR(slow[0], slow.tail(37).mean(), 1e-12);
  EXPECT_EQ(slow[2], slow[0]);
  EXPECT_NE(slow[3], slow[0]);
  EXPECT_NEAR(fast[39], fast.head(5).mean(), 1e-12);
  EXPECT_EQ(fast[5], fast[39]);
  EXPECT_NE(fast[4], fast[39]);
  for (const double turns : {1e-6, 1e6}) {
    EXPECT_TRUE((log_order_spectrum(noise(1024), turns, 96, 0.5) == std::log(0.5)).all()) << turns;
  }
}

}  // namespace
}  // namespace piae::diagnosis

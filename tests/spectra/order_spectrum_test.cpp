#include "spectra/order_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "impacts/path.hpp"
#include "support/computed_window.hpp"
#include "support/impact_windows.hpp"

namespace piae::spectra {
namespace {

/// Returns the order spectrum of a window at 12 kHz, up to the fourth harmonic of a 6205's highest
/// line.
OrderSpectrum spectrum_of(const std::vector<float>& window, double shaft_hz,
                          double prewhitening = 0) {
  const auto length = std::ssize(window);
  return order_spectrum(Eigen::Map<const Eigen::RowVectorXf>(window.data(), length).cast<double>(),
                        filter_bank(12000, length), shaft_hz, 21.92, prewhitening);
}

TEST(OrderSpectrum, MatchesNumpy) {
  const OrderSpectrum spectrum = spectrum_of(computed_window(), 30);
  const auto height = [&](double order) { return spectrum.at(order, -3, 9); };
  EXPECT_NEAR(height(0.2), -0.241855, 2e-6);
  EXPECT_NEAR(height(1), -0.273831, 2e-6);
  EXPECT_NEAR(height(3.6), 1.057884, 2e-6);
  EXPECT_NEAR(height(5.2), -0.367295, 2e-6);
  EXPECT_NEAR(height(7.2), 1.054197, 2e-6);
  EXPECT_NEAR(height(15.2), -0.459442, 2e-6);
  EXPECT_NEAR(height(21.2), -0.579987, 2e-6);
}

// The power of noise over its mean has an exponential distribution. The mean of its logarithm is
// minus Euler's constant: -0.5772 / ln 10 = -0.2507.
TEST(OrderSpectrum, NoiseIsAQuarterBelowItsFloor) {
  Stream stream("noise");
  double sum = 0;
  constexpr int windows = 20;
  for (int i = 0; i < windows; ++i) {
    const OrderSpectrum spectrum = spectrum_of(impact_window({}, stream), 30);
    sum += spectrum.heights.mean();
  }
  EXPECT_NEAR(sum / windows, -0.2507, 0.04);
}

TEST(OrderSpectrum, HasALineAtTheImpactOrderAtAnySpeed) {
  Stream stream("struck");
  for (const double shaft_hz : {10.0, 30.0, 45.0, 60.0}) {
    const OrderSpectrum spectrum =
        spectrum_of(impact_window({.impacts_hz = 4.2 * shaft_hz}, stream), shaft_hz);
    Eigen::Index highest = 0;
    spectrum.heights.maxCoeff(&highest);
    const double order = OrderSpectrum::first + OrderSpectrum::step * static_cast<double>(highest);
    const double harmonic = order / 4.2;
    EXPECT_NEAR(harmonic, std::round(harmonic), 0.05) << shaft_hz;
    EXPECT_GT(spectrum.heights[highest], 0.8) << shaft_hz;
  }
}

/// Returns noise, impacts at order 4.2, and the tones of a gear whose mesh is modulated by the
/// shaft.
std::vector<float> impacts_and_gear(Stream& stream) {
  std::vector<float> window = impact_window({.impacts_hz = 4.2 * 30}, stream);
  for (std::size_t t = 0; t < window.size(); ++t) {
    for (const double hz : {2370.0, 2400.0, 2430.0}) {
      window[t] += static_cast<float>(
          20 * std::sin(2 * std::numbers::pi * hz * static_cast<double>(t) / 12000));
    }
  }
  return window;
}

TEST(OrderSpectrum, PrewhiteningRemovesTheLinesOfTones) {
  Stream stream("gear");
  const std::vector<float> window = impacts_and_gear(stream);
  const OrderSpectrum plain = spectrum_of(window, 30);
  const OrderSpectrum half = spectrum_of(window, 30, 0.5);
  const OrderSpectrum whole = spectrum_of(window, 30, 1);
  EXPECT_GT(plain.at(1, -3, 9), whole.at(1, -3, 9) + 0.4);
  EXPECT_GT(plain.at(1, -3, 9), half.at(1, -3, 9) + 0.1);
  EXPECT_GT(whole.at(4.2, -3, 9), whole.at(1, -3, 9));
}

// Cepstral prewhitening leaves the phases alone, so no filter without phase changes the result.
TEST(OrderSpectrum, WholePrewhiteningDoesNotDependOnAFilter) {
  Stream stream("filtered");
  const std::vector<float> window = impacts_and_gear(stream);
  std::vector<double> filtered(window.begin(), window.end());
  impacts::equalise(filtered, impacts::draw_gains(stream, std::ssize(filtered) / 2 + 1,
                                                  {.spread_db = 10, .knots = 9}));
  const OrderSpectrum before = spectrum_of(window, 30, 1);
  const OrderSpectrum after = spectrum_of({filtered.begin(), filtered.end()}, 30, 1);
  EXPECT_LT((before.heights - after.heights).abs().mean(), 1e-4);
  const OrderSpectrum plain = spectrum_of(window, 30);
  const OrderSpectrum other = spectrum_of({filtered.begin(), filtered.end()}, 30);
  EXPECT_GT((plain.heights - other.heights).abs().mean(), 1e-3);
}

TEST(OrderSpectrum, InterpolatesBetweenClippedHeights) {
  const OrderSpectrum spectrum{Eigen::Array4d(-2, 1, 3, 0)};
  EXPECT_NEAR(spectrum.at(0.2, -3, 9), -2, 1e-12);
  EXPECT_NEAR(spectrum.at(0.225, -3, 9), -0.5, 1e-9);
  EXPECT_NEAR(spectrum.at(0.225, -1, 9), 0, 1e-9);     // between -1 and 1
  EXPECT_NEAR(spectrum.at(0.26, -1, 2.5), 1.3, 1e-9);  // a fifth of the way from 1 to 2.5
}

}  // namespace
}  // namespace piae::spectra

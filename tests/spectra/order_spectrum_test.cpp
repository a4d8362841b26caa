#include "spectra/order_spectrum.hpp"

#include <gtest/gtest.h>

#include "support/computed_window.hpp"
#include "support/impact_windows.hpp"

namespace piae::spectra {
namespace {

/// Returns the order spectrum of a window at 12 kHz, up to the fourth harmonic of a 6205's highest
/// line.
OrderSpectrum spectrum_of(const std::vector<float>& window, double shaft_hz) {
  const auto length = std::ssize(window);
  return order_spectrum(Eigen::Map<const Eigen::RowVectorXf>(window.data(), length).cast<double>(),
                        filter_bank(12000, length), shaft_hz, 21.92);
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

TEST(OrderSpectrum, InterpolatesBetweenClippedHeights) {
  const OrderSpectrum spectrum{Eigen::Array4d(-2, 1, 3, 0)};
  EXPECT_NEAR(spectrum.at(0.2, -3, 9), -2, 1e-12);
  EXPECT_NEAR(spectrum.at(0.225, -3, 9), -0.5, 1e-9);
  EXPECT_NEAR(spectrum.at(0.225, -1, 9), 0, 1e-9);     // between -1 and 1
  EXPECT_NEAR(spectrum.at(0.26, -1, 2.5), 1.3, 1e-9);  // a fifth of the way from 1 to 2.5
}

}  // namespace
}  // namespace piae::spectra

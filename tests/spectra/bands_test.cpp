#include "spectra/bands.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/computed_window.hpp"
#include "support/errors.hpp"

namespace piae::spectra {
namespace {

TEST(NarrowBands, AreNineUpTo6300HzOrFewerAtLowRates) {
  const std::vector<Band> bands = narrow_bands(12000);
  ASSERT_EQ(bands.size(), 9U);
  EXPECT_EQ(bands.front().low_hz, 300);
  EXPECT_EQ(bands.front().high_hz, 1500);
  EXPECT_EQ(bands.back().low_hz, 5100);
  EXPECT_EQ(bands.back().high_hz, 6300);
  EXPECT_EQ(narrow_bands(51200).size(), 9U);
  EXPECT_EQ(narrow_bands(6000).size(), 4U);  // centred on 900, 1500, 2100 and 2700 Hz
  EXPECT_EQ(narrow_bands(1800).size(), 1U);
  EXPECT_TRUE(narrow_bands(1799).empty());
}

// sin^2 of 45 degrees is a half.
TEST(Response, IsOneInsideHalfAtTheEdgesAndZeroOutside) {
  const Eigen::ArrayXd passed = response({.low_hz = 300, .high_hz = 1500}, 241, 25);
  EXPECT_NEAR(passed[300 / 25], 0.5, 1e-12);
  EXPECT_NEAR(passed[1500 / 25], 0.5, 1e-12);
  EXPECT_NEAR(passed[325 / 25], 0.853553, 1e-6);  // sin^2 of 67.5 degrees
  EXPECT_EQ(passed[900 / 25], 1);
  EXPECT_EQ(passed[350 / 25], 1);
  EXPECT_EQ(passed[250 / 25], 0);
  EXPECT_NEAR(passed[1550 / 25], 0, 1e-12);
  EXPECT_EQ(passed[0], 0);
}

TEST(FilterBank, HasTheResponsesOfAllBandsAtTheBinsOfAWindow) {
  const FilterBank bank = filter_bank(12000, 480);
  ASSERT_EQ(bank.responses.size(), 9U);
  EXPECT_EQ(bank.rate_hz, 12000);
  const Eigen::ArrayXd second = response({.low_hz = 900, .high_hz = 2100}, 241, 25);
  EXPECT_TRUE((bank.responses[1] == second).all());
}

TEST(BandMeans, AverageTheBinsBetweenEdges) {
  Eigen::ArrayXd power(6);
  power << 9, 1, 3, 2, 4, 6;
  const Eigen::ArrayXd means = band_means(power, {1, 3, 6});
  ASSERT_EQ(means.size(), 2);
  EXPECT_EQ(means[0], 2);
  EXPECT_EQ(means[1], 4);
}

Eigen::RowVectorXd computed_row() {
  const std::vector<float> window = computed_window();
  return Eigen::Map<const Eigen::RowVectorXf>(window.data(), std::ssize(window)).cast<double>();
}

Eigen::RowVectorXd sine(Eigen::Index length, double cycles_a_sample) {
  return (Eigen::ArrayXd::LinSpaced(length, 0, static_cast<double>(length - 1)) * 2 *
          std::numbers::pi * cycles_a_sample)
      .sin();
}

TEST(SpectralShape, MatchesNumpy) {
  const Eigen::ArrayXd shape = spectral_shape_db(computed_row());
  ASSERT_EQ(shape.size(), 48);
  EXPECT_NEAR(shape[0], -0.84446, 2e-5);
  EXPECT_NEAR(shape[1], -1.59819, 2e-5);
  EXPECT_NEAR(shape[23], 12.34234, 2e-5);
  EXPECT_NEAR(shape[24], 12.77869, 2e-5);
  EXPECT_NEAR(shape[47], -4.01667, 2e-5);
}

// Band b begins at (100 + b 5800 / 48) Hz of 12 kHz: 2000 Hz lies in band 15, which is 1913 to
// 2033.
TEST(SpectralShape, SineIsHighestInItsBand) {
  Eigen::Index loudest = 0;
  spectral_shape_db(sine(1024, 2000.0 / 12000)).maxCoeff(&loudest);
  EXPECT_EQ(loudest, 15);
}

TEST(SpectralShape, IgnoresLevelAndOffset) {
  const Eigen::ArrayXd plain = spectral_shape_db(computed_row());
  EXPECT_LT((spectral_shape_db(9 * computed_row().array() + 4) - plain).abs().maxCoeff(), 1e-6);
}

TEST(SpectralShape, NeedsABinInEachBand) {
  EXPECT_ERROR(spectral_shape_db(sine(60, 0.1)), Exit::bad_input, "windows of 60 samples");
  EXPECT_EQ(spectral_shape_db(sine(100, 0.1)).size(), 48);
}

TEST(BandLevels, MatchNumpy) {
  const Eigen::ArrayXd levels =
      band_levels_db(computed_row(), filter_bank(12000, computed_row().size()));
  ASSERT_EQ(levels.size(), 9);
  EXPECT_NEAR(levels[0], -11.96366, 2e-5);
  EXPECT_NEAR(levels[3], -1.50457, 2e-5);
  EXPECT_NEAR(levels[8], -14.71241, 2e-5);
}

// 2700 Hz lies in the middle of one band and at the edges of others.
TEST(BandLevels, SineGivesZeroInItsBand) {
  const Eigen::ArrayXd levels =
      band_levels_db(sine(4096, 2700.0 / 12000), filter_bank(12000, 4096));
  EXPECT_NEAR(levels[3], 0, 1e-4);  // 2100 to 3300 Hz
  EXPECT_LT(levels[0], -40);
}

}  // namespace
}  // namespace piae::spectra

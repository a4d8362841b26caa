#include "symptoms/band_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/errors.hpp"
#include "symptoms/computed_window.hpp"

namespace piae::symptoms {
namespace {

Eigen::RowVectorXd computed_row() {
  const std::vector<float> window = computed_window();
  return Eigen::Map<const Eigen::RowVectorXf>(window.data(), std::ssize(window)).cast<double>();
}

Eigen::RowVectorXd sine(Eigen::Index length, double cycles_a_sample) {
  return (Eigen::ArrayXd::LinSpaced(length, 0, static_cast<double>(length - 1)) * 2 *
          std::numbers::pi * cycles_a_sample)
      .sin();
}

TEST(SpectralShape, IsThatOfNumpy) {
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
TEST(SpectralShape, OfASineIsHighestInItsBand) {
  Eigen::Index loudest = 0;
  spectral_shape_db(sine(1024, 2000.0 / 12000)).maxCoeff(&loudest);
  EXPECT_EQ(loudest, 15);
}

TEST(SpectralShape, IsTheSameForALouderWindowWithAnOffset) {
  const Eigen::ArrayXd plain = spectral_shape_db(computed_row());
  EXPECT_LT((spectral_shape_db(9 * computed_row().array() + 4) - plain).abs().maxCoeff(), 1e-6);
}

TEST(SpectralShape, NeedsAFrequencyInEachBand) {
  EXPECT_ERROR(spectral_shape_db(sine(60, 0.1)), Exit::bad_input, "windows of 60 samples");
  EXPECT_EQ(spectral_shape_db(sine(100, 0.1)).size(), 48);
}

TEST(BandLevels, AreThoseOfNumpy) {
  const Eigen::ArrayXd levels =
      band_levels_db(computed_row(), filter_bank(12000, computed_row().size()));
  ASSERT_EQ(levels.size(), 9);
  EXPECT_NEAR(levels[0], -11.96366, 2e-5);
  EXPECT_NEAR(levels[3], -1.50457, 2e-5);
  EXPECT_NEAR(levels[8], -14.71241, 2e-5);
}

// 2400 Hz lies in the middle of one band and at the edges of none.
TEST(BandLevels, OfASineAreZeroWhereItLiesWithin) {
  const Eigen::ArrayXd levels =
      band_levels_db(sine(4096, 2700.0 / 12000), filter_bank(12000, 4096));
  EXPECT_NEAR(levels[3], 0, 1e-4);  // 2100 to 3300 Hz
  EXPECT_LT(levels[0], -40);
}

}  // namespace
}  // namespace piae::symptoms

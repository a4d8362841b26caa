#include "trend/octave_bands.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "support/errors.hpp"
#include "support/tone.hpp"

namespace piae::trend {
namespace {

TEST(OctaveBands, DoubleInWidth) {
  const std::array<double, octaves + 1> edges_hz{0, 400, 800, 1600, 3200, 6400, 12800};
  for (std::size_t i = 0; i < octaves; ++i) {
    EXPECT_DOUBLE_EQ(octave_bands(25600).at(i).low_hz, edges_hz.at(i));
    EXPECT_DOUBLE_EQ(octave_bands(25600).at(i).high_hz, edges_hz.at(i + 1));
  }
}

// 2560 samples at 25.6 kHz: bins are 10 Hz wide.
TEST(OctaveLevels, FindTheBandOfATone) {
  const std::array<int, octaves> tens_of_hz{20, 60, 120, 240, 480, 960};
  for (std::size_t band = 0; band < octaves; ++band) {
    Eigen::Index highest = 0;
    octave_levels_db(tone(2560, 3, tens_of_hz.at(band), 0.4).row(0)).maxCoeff(&highest);
    EXPECT_EQ(highest, static_cast<Eigen::Index>(band));
  }
}

// A band of twice as many bins halves the mean of the same power: 10 log10(2) = 3.01 dB.
TEST(OctaveLevels, AreMeansOverTheBinsOfABand) {
  const double in_80_bins = octave_levels_db(tone(2560, 1, 120, 0).row(0))[2];
  const double in_160_bins = octave_levels_db(tone(2560, 1, 240, 0).row(0))[3];
  EXPECT_NEAR(in_80_bins - in_160_bins, 3.0103, 1e-4);
  const double doubled = octave_levels_db(tone(2560, 2, 120, 0).row(0))[2];
  EXPECT_NEAR(doubled - in_80_bins, 6.0206, 1e-4);
}

TEST(OctaveLevels, AreEqualForWhiteNoise) {
  Stream random("octaves");
  Eigen::RowVectorXd noise(1 << 16);
  for (double& x : noise) x = random.normal(0, 1);
  const Eigen::ArrayXd levels_db = octave_levels_db(noise);
  EXPECT_LT(levels_db.maxCoeff() - levels_db.minCoeff(), 0.6);
}

TEST(OctaveLevels, NeedEnoughSamples) {
  EXPECT_EQ(octave_levels_db(tone(128, 1, 30, 0).row(0)).size(), 6);
  EXPECT_ERROR(octave_levels_db(tone(127, 1, 30, 0).row(0)), Exit::bad_input,
               "127 samples are too short");
}

}  // namespace
}  // namespace piae::trend

#include "trend/octave_bands.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "support/errors.hpp"
#include "support/tone.hpp"
#include "trend/low_pass.hpp"

namespace piae::trend {
namespace {

TEST(OctaveBands, DoubleInWidth) {
  const std::array<double, octaves + 1> edges_hz{0, 312.5, 625, 1250, 2500, 5000, 10000};
  for (std::size_t i = 0; i < octaves; ++i) {
    EXPECT_DOUBLE_EQ(octave_bands(25600).at(i).low_hz, edges_hz.at(i));
    EXPECT_DOUBLE_EQ(octave_bands(25600).at(i).high_hz, edges_hz.at(i + 1));
  }
}

// 2560 samples at 25.6 kHz: bins are 10 Hz wide.
TEST(OctaveLevels, FindTheBandOfATone) {
  const std::array<int, octaves> tens_of_hz{20, 45, 90, 200, 400, 800};
  for (std::size_t band = 0; band < octaves; ++band) {
    Eigen::Index highest = 0;
    octave_levels_db(tone(2560, 3, tens_of_hz.at(band), 0.4).row(0)).maxCoeff(&highest);
    EXPECT_EQ(highest, static_cast<Eigen::Index>(band));
  }
}

// Bins 63 to 124 are 62, bins 125 to 249 are 125: the mean of the same power differs by
// 10 log10(125 / 62) = 3.0452 dB.
TEST(OctaveLevels, AreMeansOverTheBinsOfABand) {
  const double in_62_bins = octave_levels_db(tone(2560, 1, 100, 0).row(0))[2];
  const double in_125_bins = octave_levels_db(tone(2560, 1, 200, 0).row(0))[3];
  EXPECT_NEAR(in_62_bins - in_125_bins, 3.0452, 1e-4);
  const double doubled = octave_levels_db(tone(2560, 2, 100, 0).row(0))[2];
  EXPECT_NEAR(doubled - in_62_bins, 6.0206, 1e-4);
}

// Sensors and recorders are not trusted there.
TEST(OctaveLevels, LeaveOutWhatLiesAboveTheBandwidth) {
  const Eigen::RowVectorXd inside = tone(2560, 1, 200, 0).row(0);
  const Eigen::RowVectorXd both = inside + tone(2560, 5, 1010, 0).row(0);
  EXPECT_NEAR((octave_levels_db(both) - octave_levels_db(inside))[3], 0, 1e-6);
  EXPECT_NEAR((low_passed(both) - inside).cwiseAbs().maxCoeff(), 0, 1e-9);
  const Eigen::RowVectorXd shifted = (inside.array() + 7).matrix();
  EXPECT_NEAR((low_passed(shifted) - inside).cwiseAbs().maxCoeff(), 0, 1e-9);
}

TEST(OctaveLevels, AreEqualForWhiteNoise) {
  Stream random("octaves");
  Eigen::RowVectorXd noise(1 << 16);
  for (double& x : noise) x = random.normal(0, 1);
  const Eigen::ArrayXd levels_db = octave_levels_db(noise);
  EXPECT_LT(levels_db.maxCoeff() - levels_db.minCoeff(), 0.6);
}

TEST(OctaveLevels, NeedEnoughSamples) {
  EXPECT_EQ(octave_levels_db(tone(256, 1, 30, 0).row(0)).size(), 6);
  EXPECT_ERROR(octave_levels_db(tone(255, 1, 30, 0).row(0)), Exit::bad_input,
               "255 samples are too short");
}

}  // namespace
}  // namespace piae::trend

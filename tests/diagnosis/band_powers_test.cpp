#include "diagnosis/band_powers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnosis/sets.hpp"
#include "support/errors.hpp"

namespace piae::diagnosis {
namespace {

signal::WindowSet one_window(const std::vector<float>& samples) {
  signal::WindowSet set = empty_set(samples.size());
  set.samples = samples;
  set.labels = {0};
  return set;
}

// Four of the 512 bins above the offset make a band: the 102nd bin is in the 26th band.
TEST(BandPowers, OfAToneAreHighestWhereItIs) {
  std::vector<float> tone;
  for (int t = 0; t < 1024; ++t) {
    tone.push_back(static_cast<float>(std::sin(2 * std::numbers::pi * 102 * t / 1024)));
  }
  const BandPowers bands = band_powers(one_window(tone));
  ASSERT_EQ(bands.rows(), 1);
  ASSERT_EQ(bands.cols(), 128);
  Eigen::Index highest = 0;
  bands.row(0).maxCoeff(&highest);
  EXPECT_EQ(highest, 25);
}

// The spectrum of an impulse is flat. Its removed mean changes only the first bins under Hann's
// window, so all other bands are the same, as far above the mean as the first is below.
TEST(BandPowers, OfAnImpulseAreFlatAndWithoutTheirMean) {
  std::vector<float> impulse(1024);
  impulse[300] = 5;
  const BandPowers bands = band_powers(one_window(impulse));
  EXPECT_NEAR(bands.row(0).sum(), 0, 1e-9);
  for (Eigen::Index band = 2; band < 128; ++band) EXPECT_NEAR(bands(0, band), bands(0, 1), 1e-6);
  EXPECT_NEAR(bands(0, 0), -127 * bands(0, 1), 1e-6);
}

TEST(BandPowers, DoNotTellLevelAndOffset) {
  Stream stream("bands");
  std::vector<float> quiet(1024);
  for (float& sample : quiet) sample = static_cast<float>(stream.normal(0, 1));
  std::vector<float> loud = quiet;
  for (float& sample : loud) sample = 64 * sample + 100;
  const BandPowers difference = band_powers(one_window(quiet)) - band_powers(one_window(loud));
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-3);
}

TEST(BandPowers, NeedTwoBinsABand) {
  EXPECT_EQ(band_powers(one_window(std::vector<float>(256, 1.0F))).rows(), 1);
  EXPECT_ERROR(band_powers(one_window(std::vector<float>(255, 1.0F))), Exit::bad_input,
               "windows of 255 samples: 128 bands need 256 samples or more");
}

}  // namespace
}  // namespace piae::diagnosis

#include "scoring/waveform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "scoring/sets.hpp"
#include "support/tone.hpp"

namespace piae::scoring {
namespace {

TEST(Rmse, IsTheMeanOverPairsNotTheRootOfTheMeanSquare) {
  Windows generated(2, 2);
  generated << 3, 4, 1, 1;
  Windows real(2, 2);
  real << 0, 0, 2, 2;
  EXPECT_NEAR(rmse(generated, real), (std::sqrt(12.5) + 1) / 2, 1e-15);
}

TEST(Rmse, IsTheRmsOfTheRealWindowForSilence) {
  const Windows real = noise(1, 512, "real");
  EXPECT_NEAR(rmse(real * 0, real), std::sqrt(real.squaredNorm() / 512), 1e-15);
}

/// Lengths with and without a factor of two, and a prime.
TEST(AlignedRmse, FindsEveryCircularShift) {
  for (const Eigen::Index length : {16, 15, 13}) {
    const Windows real = noise(1, static_cast<std::size_t>(length), "real");
    for (Eigen::Index shift = 0; shift < length; ++shift) {
      Windows generated(1, length);
      for (Eigen::Index i = 0; i < length; ++i) generated(0, (i + shift) % length) = real(0, i);
      EXPECT_EQ(aligned_rmse(generated, real), 0) << length << " shifted by " << shift;
    }
  }
}

TEST(AlignedRmse, IsTheSmallestOverAllShifts) {
  const Windows generated = noise(1, 32, "generated");
  const Windows real = noise(1, 32, "real");
  double smallest = rmse(generated, real);
  Windows shifted = generated;
  for (Eigen::Index shift = 1; shift < 32; ++shift) {
    for (Eigen::Index i = 0; i < 32; ++i) shifted(0, i) = generated(0, (i + shift) % 32);
    smallest = std::min(smallest, rmse(shifted, real));
  }
  EXPECT_LT(smallest, rmse(generated, real));
  EXPECT_EQ(aligned_rmse(generated, real), smallest);
}

/// A shift can change a sine into its negative; a pulse has no such shift.
TEST(AlignedRmse, DoesNotInvertWindows) {
  Windows real = Windows::Zero(1, 8);
  real(0, 3) = 1;
  EXPECT_NEAR(aligned_rmse(-real, real), std::sqrt(2.0 / 8), 1e-12);
}

TEST(AmplitudeRatio, IsGeneratedOverReal) {
  const Windows real = noise(5, 64, "real");
  EXPECT_NEAR(amplitude_ratio(real * -2, real), 2, 1e-14);
  EXPECT_EQ(amplitude_ratio(real * 0, real), 0);
  EXPECT_THROW(amplitude_ratio(real, real * 0), std::logic_error);
}

TEST(Waveform, RefusesUnpairedWindows) {
  const Windows two = noise(2, 8, "x");
  for (const Windows& other : {noise(3, 8, "y"), noise(2, 9, "y"), Windows(0, 8)}) {
    EXPECT_THROW(rmse(two, other), std::logic_error);
    EXPECT_THROW(aligned_rmse(two, other), std::logic_error);
    EXPECT_THROW(amplitude_ratio(two, other), std::logic_error);
  }
  EXPECT_THROW(rmse(Windows(0, 8), Windows(0, 8)), std::logic_error);
}

TEST(SpectralDistance, TenTimesTheAmplitudeIsTwentyDecibels) {
  const Windows real = noise(20, 128, "real");
  EXPECT_NEAR(spectral_distance_db(real * 10, real), 20, 1e-10);
  EXPECT_NEAR(spectral_distance_db(real * 0.1, real), 20, 1e-10);
  EXPECT_EQ(spectral_distance_db(real, real), 0);
}

/// The tone's three of 32 bins differ by 10 dB.
TEST(SpectralDistance, IsTheRootMeanSquareOverBins) {
  const Windows real = tone(64, 1, 8, 0) + tone(64, 1, 20, 0);
  const Windows generated = tone(64, std::sqrt(10.0), 8, 2) + tone(64, 1, 20, 1);
  EXPECT_NEAR(spectral_distance_db(generated, real), std::sqrt(3 * 100.0 / 32), 1e-9);
}

TEST(SpectralDistance, IgnoresAShift) {
  const Windows real = tone(64, 1, 8, 0);
  EXPECT_NEAR(spectral_distance_db(tone(64, 1, 8, 1.3), real), 0, 1e-6);
}

/// A pulse in the middle has the same power P in all bins but the first, whose mean is removed.
/// Relative to the mean power, silence is at -100 dB, except for the dip that the removal leaves in
/// bin 1.
TEST(SpectralDistance, SilenceIsFarButFinite) {
  Windows real = Windows::Zero(1, 1024);
  real(0, 512) = 1;
  EXPECT_NEAR(spectral_distance_db(real * 0, real), 100, 0.01);
}

TEST(SpectralDistance, RefusesWindowsOfDifferentLength) {
  EXPECT_THROW(spectral_distance_db(noise(2, 8, "x"), noise(2, 16, "y")), std::logic_error);
  EXPECT_THROW(spectral_distance_db(noise(2, 8, "x"), Windows::Ones(2, 8)), std::logic_error);
  EXPECT_THROW(spectral_distance_db(Windows(1, 1), Windows(1, 1)), std::logic_error);
}

}  // namespace
}  // namespace piae::scoring

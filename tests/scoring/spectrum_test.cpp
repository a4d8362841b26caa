#include "scoring/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "scoring/sets.hpp"

namespace piae::scoring {
namespace {

Windows tone(Eigen::Index length, double amplitude, int cycles, double phase) {
  Windows window(1, length);
  for (Eigen::Index i = 0; i < length; ++i) {
    window(0, i) = amplitude * std::cos(2 * std::numbers::pi * cycles * static_cast<double>(i) /
                                            static_cast<double>(length) +
                                        phase);
  }
  return window;
}

/// Hann's window spreads a tone A cos over three bins of height A N / 8, A N / 4, A N / 8.
TEST(Spectrum, OfAToneIsThreeLinesOfTheWindow) {
  const Eigen::ArrayXd power = mean_power_spectrum(tone(64, 3, 8, 0.7));
  ASSERT_EQ(power.size(), 33);
  for (Eigen::Index bin = 0; bin < 33; ++bin) {
    const double expected = bin == 8 ? 48.0 * 48 : bin == 7 || bin == 9 ? 24.0 * 24 : 0;
    EXPECT_NEAR(power[bin], expected, 1e-9) << bin;
  }
}

TEST(Spectrum, IsTheMeanOverWindowsAndSeesNoOffset) {
  Windows windows(2, 64);
  windows << tone(64, 3, 8, 0.7), tone(64, 3, 8, 0.7) * 0;
  windows.array() += 100;
  EXPECT_NEAR(mean_power_spectrum(windows)[8], 48.0 * 48 / 2, 1e-8);
  EXPECT_NEAR(mean_power_spectrum(windows)[1], 0, 1e-8);
}

TEST(SpectralDistance, OfTenTimesTheAmplitudeIsTwentyDecibels) {
  const Windows real = noise(20, 128, "real");
  EXPECT_NEAR(spectral_distance_db(real * 10, real), 20, 1e-10);
  EXPECT_NEAR(spectral_distance_db(real * 0.1, real), 20, 1e-10);
  EXPECT_EQ(spectral_distance_db(real, real), 0);
}

/// Of 32 bins, those three where the tone is are 10 dB apart.
TEST(SpectralDistance, IsTheRootMeanSquareOverBins) {
  const Windows real = tone(64, 1, 8, 0) + tone(64, 1, 20, 0);
  const Windows generated = tone(64, std::sqrt(10.0), 8, 2) + tone(64, 1, 20, 1);
  EXPECT_NEAR(spectral_distance_db(generated, real), std::sqrt(3 * 100.0 / 32), 1e-9);
}

TEST(SpectralDistance, DoesNotSeeAShift) {
  const Windows real = tone(64, 1, 8, 0);
  EXPECT_NEAR(spectral_distance_db(tone(64, 1, 8, 1.3), real), 0, 1e-6);
}

/// A pulse in the middle has the same power P in all bins but the first, whose mean is removed:
/// with the mean power as reference silence is 100 dB down, save for the dip that removal leaves in
/// bin 1.
TEST(SpectralDistance, OfSilenceIsFarButFinite) {
  Windows real = Windows::Zero(1, 1024);
  real(0, 512) = 1;
  EXPECT_NEAR(spectral_distance_db(real * 0, real), 100, 0.01);
}

TEST(SpectralDistance, RefusesWhatItCannotCompare) {
  EXPECT_THROW(spectral_distance_db(noise(2, 8, "x"), noise(2, 16, "y")), std::logic_error);
  EXPECT_THROW(spectral_distance_db(noise(2, 8, "x"), Windows::Ones(2, 8)), std::logic_error);
  EXPECT_THROW(spectral_distance_db(Windows(1, 1), Windows(1, 1)), std::logic_error);
}

}  // namespace
}  // namespace piae::scoring

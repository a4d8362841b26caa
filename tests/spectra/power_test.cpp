#include "spectra/power.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "support/tone.hpp"

namespace piae::spectra {
namespace {

/// Returns 3 cos with 4 cycles in 32 samples from `first` on, and 0 before.
Eigen::RowVectorXd tone_from(Eigen::Index first) {
  Eigen::RowVectorXd window = Eigen::RowVectorXd::Zero(128);
  for (Eigen::Index i = first; i < window.size(); ++i) {
    window[i] = 3 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / 8);
  }
  return window;
}

/// Hann's window spreads a tone A cos over three bins of height A N / 8, A N / 4, A N / 8.
TEST(Spectrogram, ToneHasItsLineAtAllTimes) {
  const Eigen::ArrayXXd power = spectrogram(tone_from(0), 32);
  ASSERT_EQ(power.rows(), 7);  // from samples 0, 16, ..., 96
  ASSERT_EQ(power.cols(), 17);
  for (Eigen::Index time = 0; time < 7; ++time) {
    for (Eigen::Index bin = 0; bin < 17; ++bin) {
      const double expected = bin == 4 ? 24.0 * 24 : bin == 3 || bin == 5 ? 12.0 * 12 : 0;
      EXPECT_NEAR(power(time, bin), expected, 1e-9) << time << " " << bin;
    }
  }
}

TEST(Spectrogram, ShowsWhenAToneStarts) {
  const Eigen::ArrayXXd power = spectrogram(tone_from(64), 32);
  for (Eigen::Index time = 0; time < 3; ++time) EXPECT_EQ(power(time, 4), 0) << time;
  EXPECT_GT(power(3, 4), 100);  // the tone fills its second half
  for (Eigen::Index time = 4; time < 7; ++time) EXPECT_NEAR(power(time, 4), 576, 1e-9) << time;
}

TEST(Spectrogram, LeavesOutAnIncompleteSegment) {
  EXPECT_EQ(spectrogram(tone_from(0).head(127), 32).rows(), 6);
}

TEST(Spectrogram, RefusesImpossibleSegments) {
  EXPECT_THROW(spectrogram(tone_from(0), 0), std::logic_error);
  EXPECT_THROW(spectrogram(tone_from(0), 31), std::logic_error);
  EXPECT_THROW(spectrogram(tone_from(0), 130), std::logic_error);
}

/// Hann's window spreads a tone A cos over three bins of height A N / 8, A N / 4, A N / 8.
TEST(Spectrum, ToneHasThreeLinesOfTheTaper) {
  const Eigen::ArrayXd power = mean_power_spectrum(tone(64, 3, 8, 0.7));
  ASSERT_EQ(power.size(), 33);
  for (Eigen::Index bin = 0; bin < 33; ++bin) {
    const double expected = bin == 8 ? 48.0 * 48 : bin == 7 || bin == 9 ? 24.0 * 24 : 0;
    EXPECT_NEAR(power[bin], expected, 1e-9) << bin;
  }
}

TEST(Spectrum, AveragesWindowsAndIgnoresOffset) {
  Windows windows(2, 64);
  windows << tone(64, 3, 8, 0.7), tone(64, 3, 8, 0.7) * 0;
  windows.array() += 100;
  EXPECT_NEAR(mean_power_spectrum(windows)[8], 48.0 * 48 / 2, 1e-8);
  EXPECT_NEAR(mean_power_spectrum(windows)[1], 0, 1e-8);
}

/// A carrier of whole cycles: its envelope is A (1 + m cos), whatever the window's offset.
TEST(Envelope, ModulatedCarrierGivesItsModulation) {
  constexpr Eigen::Index n = 1024;
  constexpr double cycle = 2 * std::numbers::pi / 1024;
  Windows window(1, n);
  Eigen::RowVectorXd modulation(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    modulation[i] = 2 * (1 + 0.5 * std::cos(10 * cycle * static_cast<double>(i)));
    window(0, i) = 5 + modulation[i] * std::cos(200 * cycle * static_cast<double>(i) + 0.3);
  }
  EXPECT_LT((envelopes(window).row(0) - modulation).cwiseAbs().maxCoeff(), 1e-10);
}

}  // namespace
}  // namespace piae::spectra

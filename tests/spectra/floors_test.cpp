#include "spectra/floors.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace piae::spectra {
namespace {

// Medians over three numbers of 5 | 5 1 4 2 3 | 3, and over five of 1 5 | 5 1 4 2 3 | 3 2.
TEST(RunningMedian, MirrorsBeyondTheEnds) {
  Eigen::ArrayXd values(5);
  values << 5, 1, 4, 2, 3;
  Eigen::ArrayXd of_three(5);
  of_three << 5, 4, 2, 3, 3;
  Eigen::ArrayXd of_five(5);
  of_five << 4, 4, 3, 3, 3;
  EXPECT_TRUE((running_median(values, 3) == of_three).all());
  EXPECT_TRUE((running_median(values, 5) == of_five).all());
}

// Hann's weights over three numbers are 1/4, 1/2, 1/4. The mirror repeats the second number before
// the first and the last but one after the last.
TEST(Smoothed, IsAWeightedMeanWithMirrorsAtTheEnds) {
  const Eigen::ArrayXd means = smoothed(Eigen::Array4d(0, 4, 0, 8), 3);
  EXPECT_NEAR(means[0], 2, 1e-12);
  EXPECT_NEAR(means[1], 2, 1e-12);
  EXPECT_NEAR(means[2], 3, 1e-12);
  EXPECT_NEAR(means[3], 4, 1e-12);
}

/// Returns noise with a resonance at a quarter of the rate: x[t] = n[t] - 0.9 x[t - 2].
Eigen::RowVectorXd ringing_noise() {
  Stream stream("noise");
  Eigen::RowVectorXd window(4096);
  for (Eigen::Index t = 0; t < window.size(); ++t) {
    window[t] = stream.normal(0, 1) - (t < 2 ? 0 : 0.9 * window[t - 2]);
  }
  return window;
}

TEST(WhitenedSpectrum, IsFlat) {
  const Eigen::ArrayXd power = whitened_spectrum(ringing_noise(), 12000).abs2();
  for (Eigen::Index first = 0; first + 128 < power.size(); first += 128) {
    EXPECT_NEAR(power.segment(first, 128).mean(), 1, 0.15) << first;
  }
}

TEST(WhitenedSpectrum, IgnoresLevelAndOffset) {
  const Eigen::ArrayXcd plain = whitened_spectrum(ringing_noise(), 12000);
  const Eigen::ArrayXcd louder = whitened_spectrum(50 * ringing_noise().array() + 7, 12000);
  EXPECT_LT((plain - louder).abs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace piae::spectra

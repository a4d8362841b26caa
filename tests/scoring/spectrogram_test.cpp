#include "scoring/spectrogram.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace piae::scoring {
namespace {

/// 3 cos with 4 cycles in 32 samples, from `first` on; silence before.
Eigen::RowVectorXd tone_from(Eigen::Index first) {
  Eigen::RowVectorXd window = Eigen::RowVectorXd::Zero(128);
  for (Eigen::Index i = first; i < window.size(); ++i) {
    window[i] = 3 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / 8);
  }
  return window;
}

/// Hann's window spreads a tone A cos over three bins of height A N / 8, A N / 4, A N / 8.
TEST(Spectrogram, OfAToneHasItsLinesAtAllTimes) {
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

TEST(Spectrogram, ShowsWhenAToneBegins) {
  const Eigen::ArrayXXd power = spectrogram(tone_from(64), 32);
  for (Eigen::Index time = 0; time < 3; ++time) EXPECT_EQ(power(time, 4), 0) << time;
  EXPECT_GT(power(3, 4), 100);  // its second half sounds
  for (Eigen::Index time = 4; time < 7; ++time) EXPECT_NEAR(power(time, 4), 576, 1e-9) << time;
}

TEST(Spectrogram, LeavesOutWhatDoesNotFillASegment) {
  EXPECT_EQ(spectrogram(tone_from(0).head(127), 32).rows(), 6);
}

TEST(Spectrogram, OfImpossibleSegmentsCannotBe) {
  EXPECT_THROW(spectrogram(tone_from(0), 0), std::logic_error);
  EXPECT_THROW(spectrogram(tone_from(0), 31), std::logic_error);
  EXPECT_THROW(spectrogram(tone_from(0), 130), std::logic_error);
}

}  // namespace
}  // namespace piae::scoring

#include "transfer/playback.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace piae::transfer {
namespace {

/// `turns` periods of a sine, which ends where it begins.
std::vector<float> sine_of(int turns, std::size_t length) {
  std::vector<float> window(length);
  for (std::size_t t = 0; t < length; ++t) {
    window[t] = static_cast<float>(std::sin(2 * std::numbers::pi * turns * static_cast<double>(t) /
                                            static_cast<double>(length)));
  }
  return window;
}

/// The sine of that many radians a sample that fits best, as a phasor: sin is 1, cos is i.
std::complex<double> phasor(const std::vector<double>& samples, double radians_per_sample) {
  std::complex<double> sum;
  for (std::size_t t = 0; t < samples.size(); ++t) {
    const double angle = radians_per_sample * static_cast<double>(t);
    sum += samples[t] * std::complex<double>(std::sin(angle), std::cos(angle));
  }
  return 2.0 * sum / static_cast<double>(samples.size());
}

TEST(Playback, PlaysASineAtAnotherPitchFromTheSampleThatWasAskedFor) {
  constexpr std::size_t length = 1024;
  constexpr std::size_t start = 300;
  for (const double factor : {0.5, 0.75, 0.8342, 1.0, 1.5, 2.0}) {
    const std::vector<double> fast = played(sine_of(64, length), start, factor);
    ASSERT_EQ(fast.size(), length) << factor;
    const double pitch = 2 * std::numbers::pi * 64 / length;
    const std::complex<double> found = phasor(fast, pitch * factor);
    EXPECT_NEAR(std::abs(found), 1, 0.01) << factor;
    // A period is 16 samples long.
    const double samples = std::remainder(std::arg(found) / pitch - start, 16);
    EXPECT_GT(samples, -1.01) << factor;
    EXPECT_LT(samples, 0.01) << factor;
  }
}

TEST(Playback, IsTheWindowTurnedRoundAtItsOwnSpeed) {
  const std::vector<float> window{1, 2, 3, 4};
  EXPECT_EQ(played(window, 3, 1), (std::vector<double>{4, 1, 2, 3}));
}

TEST(Playback, FoldsNothingOverAndAddsNothingAbove) {
  constexpr std::size_t length = 1024;
  const std::vector<double> fast = played(sine_of(400, length), 0, 1.5);  // 1.17 times Nyquist's
  for (const double x : fast) EXPECT_NEAR(x, 0, 0.02);
}

}  // namespace
}  // namespace piae::transfer

#include "inspection/level.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.hpp"

namespace piae::inspection {
namespace {

using std::numbers::pi;

/// A sin: A / sqrt(2), 3/8 A^4 over (A^2 / 2)^2, A over A / sqrt(2), for any offset.
TEST(Level, MatchesTheClosedFormOfASine) {
  std::vector<double> sine(4000);
  for (int i = 0; i < 4000; ++i) sine[i] = 7 + 2 * std::sin(2 * pi * i / 40);
  const Level level = level_of(sine);
  EXPECT_NEAR(level.rms, 2 / std::numbers::sqrt2, 1e-9);
  EXPECT_NEAR(level.kurtosis, 1.5, 1e-9);
  EXPECT_NEAR(level.crest_factor, std::numbers::sqrt2, 1e-9);
}

/// One of n samples is 1, the others 0: the mean is p = 1 / n, the second moment p (1 - p), the
/// fourth p (1 - p) (1 - 3 p (1 - p)).
TEST(Level, MatchesTheClosedFormOfOneImpact) {
  constexpr double p = 0.01;
  std::vector<double> strike(100, 0.0);
  strike[31] = 1;
  const Level level = level_of(strike);
  EXPECT_NEAR(level.rms, std::sqrt(p * (1 - p)), 1e-12);
  EXPECT_NEAR(level.kurtosis, (1 - 3 * p * (1 - p)) / (p * (1 - p)), 1e-9);
  EXPECT_NEAR(level.crest_factor, (1 - p) / std::sqrt(p * (1 - p)), 1e-9);
}

/// The kurtosis of n normal numbers scatters by sqrt(24 / n).
TEST(Level, HasAKurtosisOfThreeForNormalNoise) {
  Stream stream("level");
  std::vector<double> noise(60000);
  for (double& x : noise) x = stream.normal(0, 0.3);
  EXPECT_NEAR(level_of(noise).kurtosis, 3, 0.08);
  EXPECT_NEAR(level_of(noise).rms, 0.3, 0.004);
}

}  // namespace
}  // namespace piae::inspection

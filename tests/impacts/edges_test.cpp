#include "impacts/edges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.hpp"

namespace piae::impacts {
namespace {

TEST(Edges, WeakenFrequenciesWithWholePeriodsInTheLag) {
  const Edges edges{.lag_s = 1e-3, .exit = 0.6};
  EXPECT_NEAR(std::abs(edges.gain(0)), 0.4, 1e-12);
  EXPECT_NEAR(std::abs(edges.gain(500)), 1.6, 1e-12);
  EXPECT_NEAR(std::abs(edges.gain(1000)), 0.4, 1e-12);
  EXPECT_NEAR(std::abs(edges.gain(1250)), std::hypot(1, 0.6), 1e-12);
}

TEST(Edges, AreTheTransformOfTwoImpulses) {
  // An impulse at 0 and one of -0.6 at 1 ms: the sum of their exponentials.
  const Edges edges{.lag_s = 1e-3, .exit = 0.6};
  for (const double hz : {100.0, 333.0, 2750.0}) {
    const double angle = 2 * std::numbers::pi * hz * 1e-3;
    EXPECT_NEAR(edges.gain(hz).real(), 1 - 0.6 * std::cos(angle), 1e-12);
    EXPECT_NEAR(edges.gain(hz).imag(), 0.6 * std::sin(angle), 1e-12);
  }
}

TEST(Edges, AreTheMeanOverImpacts) {
  const Edges edges{.lag_s = 1e-3, .exit = 0.8, .spread = 0.05};
  Stream random("lags");
  constexpr int impacts = 20000;
  for (const double hz : {700.0, 2000.0, 4000.0}) {
    std::complex<double> sum;
    double power = 0;
    for (int i = 0; i < impacts; ++i) {
      const auto one = Edges{.lag_s = random.normal(1e-3, 0.05e-3), .exit = 0.8}.gain(hz);
      sum += one;
      power += std::norm(one);
    }
    EXPECT_NEAR(power / impacts, std::pow(edges.amplitude(hz), 2), 0.035) << hz;
    EXPECT_NEAR(std::abs(sum / double{impacts} - edges.gain(hz)), 0, 0.02) << hz;
  }
}

TEST(Edges, ChangeNothingWithoutASecondImpulse) {
  EXPECT_EQ(Edges{}.gain(1234), std::complex<double>(1));
}

}  // namespace
}  // namespace piae::impacts

#include "twin/derivatives.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace piae::twin {
namespace {

/// Fraction of the derivatives of a sine of this frequency that the taps pass, at a sample.
struct Passed {
  double first = 0;
  double second = 0;
};
Passed passed(const Stencil& stencil, double hz, double sample_rate_hz) {
  const double omega = 2 * std::numbers::pi * hz / sample_rate_hz;  // radians per sample
  Passed part;
  for (std::int64_t n = -stencil.reach; n <= stencil.reach; ++n) {
    const auto tap = static_cast<std::size_t>(n + stencil.reach);
    const double angle = omega * static_cast<double>(n);
    part.first += stencil.first[tap] * std::sin(angle) / omega;
    part.second -= stencil.second[tap] * std::cos(angle) / (omega * omega);
  }
  return part;
}

// sin(w)/w and 2 (1 - cos(w))/w^2 at w = 2 pi 3.5/12.
TEST(Derivatives, CentralDifferencesDampHighFrequencies) {
  const Passed part = passed(stencil_of(Derivatives::central), 3500, 12000);
  EXPECT_NEAR(part.first, 0.527, 0.001);
  EXPECT_NEAR(part.second, 0.749, 0.001);
}

TEST(Derivatives, SpectralOnesAreAccurateUpToFiveOfSixKilohertz) {
  const Stencil stencil = stencil_of(Derivatives::spectral);
  for (double hz = 10; hz <= 5000; hz += 10) {
    const Passed part = passed(stencil, hz, 12000);
    EXPECT_NEAR(part.first, 1, 0.005) << hz;
    EXPECT_NEAR(part.second, 1, 0.005) << hz;
  }
}

TEST(Derivatives, AreZeroForAConstant) {
  for (const auto kind : {Derivatives::central, Derivatives::spectral}) {
    double first = 0;
    double second = 0;
    const Stencil stencil = stencil_of(kind);
    for (const double tap : stencil.first) first += tap;
    for (const double tap : stencil.second) second += tap;
    EXPECT_NEAR(first, 0, 1e-15);
    EXPECT_NEAR(second, 0, 1e-14);
  }
}

}  // namespace
}  // namespace piae::twin

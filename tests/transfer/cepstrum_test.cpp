#include "transfer/cepstrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace piae::transfer {
namespace {

using Eigen::ArrayXcd;
using Eigen::ArrayXd;
using Eigen::Index;

constexpr Index cepstrum_bins = 513;

/// 1 / (1 - 2 r cos(w) z^-1 + r^2 z^-2): two poles within the unit circle, so of minimum phase.
ArrayXcd two_poles() {
  ArrayXcd response(cepstrum_bins);
  for (Index i = 0; i < cepstrum_bins; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / (cepstrum_bins - 1);
    const std::complex<double> back = std::polar(1.0, -angle);
    response[i] = 1.0 / (1.0 - 2 * 0.9 * std::cos(1.0) * back + 0.81 * back * back);
  }
  return response;
}

TEST(Cepstrum, MinimumPhaseFollowsFromTheAmplitude) {
  const ArrayXcd expected = two_poles();
  const ArrayXcd found = minimum_phase(expected.abs().log());
  for (Index i = 0; i < cepstrum_bins; ++i)
    EXPECT_NEAR(std::abs(found[i] - expected[i]), 0, 1e-9) << i;
}

TEST(Cepstrum, AResponseOfMinimumPhaseRingsAfterTheBlowAlone) {
  const ArrayXd ring = samples_of(minimum_phase(two_poles().abs().log()));
  ASSERT_EQ(ring.size(), 1024);
  EXPECT_NEAR(ring[0], 1, 1e-9);
  EXPECT_NEAR(ring[1], 1.8 * std::cos(1.0), 1e-9);
  EXPECT_NEAR(ring.tail(256).abs().maxCoeff(), 0, 1e-9);
}

TEST(Cepstrum, LifteringLeavesSlowChangesAndTakesFastOnes) {
  const auto ripple = [](double quefrency) {
    const ArrayXd places = ArrayXd::LinSpaced(cepstrum_bins, 0, std::numbers::pi);
    return ArrayXd((quefrency * places).cos());
  };
  const ArrayXd both = ripple(20) + ripple(100);
  EXPECT_NEAR((liftered(both, 80) - ripple(20)).abs().maxCoeff(), 0, 1e-9);
  // In the middle of the fall, from 56 to 80 samples, half of it is left.
  EXPECT_NEAR((liftered(ripple(68), 80) - ripple(68) / 2).abs().maxCoeff(), 0, 1e-9);
}

}  // namespace
}  // namespace piae::transfer

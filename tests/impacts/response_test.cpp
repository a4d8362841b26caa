#include "impacts/response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace piae::impacts {
namespace {

using Eigen::ArrayXcd;
using Eigen::ArrayXd;
using Eigen::Index;

constexpr Index response_bins = 513;

/// 1 / (1 - 2 r cos(w) z^-1 + r^2 z^-2): two poles within the unit circle, so the phase is minimum.
ArrayXcd two_poles() {
  ArrayXcd response(response_bins);
  for (Index i = 0; i < response_bins; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / (response_bins - 1);
    const std::complex<double> back = std::polar(1.0, -angle);
    response[i] = 1.0 / (1.0 - 2 * 0.9 * std::cos(1.0) * back + 0.81 * back * back);
  }
  return response;
}

TEST(Response, MinimumPhaseFollowsFromTheAmplitude) {
  const ArrayXcd expected = two_poles();
  const ArrayXcd found = minimum_phase(expected.abs().log());
  for (Index i = 0; i < response_bins; ++i)
    EXPECT_NEAR(std::abs(found[i] - expected[i]), 0, 1e-9) << i;
}

TEST(Response, MinimumPhaseRingsOnlyAfterTheImpact) {
  const ArrayXd ring = samples_of(minimum_phase(two_poles().abs().log()));
  ASSERT_EQ(ring.size(), 1024);
  EXPECT_NEAR(ring[0], 1, 1e-9);
  EXPECT_NEAR(ring[1], 1.8 * std::cos(1.0), 1e-9);
  EXPECT_NEAR(ring.tail(256).abs().maxCoeff(), 0, 1e-9);
}

TEST(Response, LifteringKeepsSlowChangesAndRemovesFastOnes) {
  const auto ripple = [](double quefrency) {
    const ArrayXd places = ArrayXd::LinSpaced(response_bins, 0, std::numbers::pi);
    return ArrayXd((quefrency * places).cos());
  };
  const ArrayXd both = ripple(20) + ripple(100);
  EXPECT_NEAR((liftered(both, 80) - ripple(20)).abs().maxCoeff(), 0, 1e-9);
  // Half of the ripple is left in the middle of the fall-off, which runs from 56 to 80 samples.
  EXPECT_NEAR((liftered(ripple(68), 80) - ripple(68) / 2).abs().maxCoeff(), 0, 1e-9);
}

TEST(Filter, DelaysByAPhaseThatGrowsWithTheFrequency) {
  std::vector<double> window{5, 1, 0, -2, 0, 0, 3, 0};
  std::vector<std::complex<double>> gains;
  for (int i = 0; i <= 4; ++i) gains.push_back(std::polar(1.0, -2 * std::numbers::pi * i * 3 / 8));
  filter(window, gains);
  const std::vector<double> expected{0, 3, 0, 5, 1, 0, -2, 0};
  for (std::size_t t = 0; t < 8; ++t) EXPECT_NEAR(window[t], expected[t], 1e-12) << t;
}

TEST(Filter, RefusesAWrongNumberOfGains) {
  std::vector<double> window(8, 0.0);
  EXPECT_THROW(filter(window, std::vector<std::complex<double>>(8, 1.0)), std::logic_error);
}

}  // namespace
}  // namespace piae::impacts

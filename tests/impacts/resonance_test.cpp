#include "impacts/resonance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace piae::impacts {
namespace {

constexpr double ring_rate_hz = 12000;
constexpr Eigen::Index ring_bins = 1025;

double hz_of(const signal::DynamicParameters& ring, double mass_kg) {
  return std::sqrt(ring.stiffness_n_per_m / mass_kg) / (2 * std::numbers::pi);
}

TEST(Ring, RisesToItsResonanceAndIsFlatBeyond) {
  // 1e8 N/m and 1 kg: 1591.5 Hz. At resonance |A| = w^2 / (w c) = w / c; far above it is 1 / M.
  const signal::DynamicParameters ring{1e8, 500};
  const Eigen::ArrayXd response = ring_response(ring, 1, ring_bins, ring_rate_hz);
  EXPECT_NEAR(response.mean(), 0, 1e-12);
  Eigen::Index top = 0;
  response.maxCoeff(&top);
  EXPECT_NEAR(static_cast<double>(top) * ring_rate_hz / 2048, 1591.5, 8);
  const double w_top = 2 * std::numbers::pi * static_cast<double>(top) * ring_rate_hz / 2048;
  const double w_end = std::numbers::pi * ring_rate_hz;
  const double at_end = w_end * w_end / std::hypot(1e8 - w_end * w_end, w_end * 500);  // by hand
  const double at_top = w_top * w_top / std::hypot(1e8 - w_top * w_top, w_top * 500);
  EXPECT_NEAR(response[top] - response[1024], std::log(at_top / at_end), 1e-9);
}

TEST(Ring, IsRecoveredFromPeakAndWidth) {
  for (const double hz : {400.0, 1800.0, 4100.0}) {
    const double w = 2 * std::numbers::pi * hz;
    const signal::DynamicParameters truth{2 * w * w, 2 * 0.05 * 2 * w};  // 2 kg, 5 % of critical
    const signal::DynamicParameters found =
        strongest_ring(ring_response(truth, 2, ring_bins, ring_rate_hz), 2, ring_rate_hz);
    EXPECT_NEAR(hz_of(found, 2) / hz, 1, 0.02) << hz;
    // The half-power width is 10 % of 400 Hz: 7 bins, of which up to two are rounding.
    EXPECT_NEAR(found.damping_ns_per_m / truth.damping_ns_per_m, 1, 0.35) << hz;
  }
}

TEST(Ring, IsTheStrongestOfSeveralResonances) {
  const auto hz_w = [](double hz) { return 2 * std::numbers::pi * hz; };
  const signal::DynamicParameters low{std::pow(hz_w(1000), 2), 0.02 * hz_w(1000)};
  const signal::DynamicParameters high{std::pow(hz_w(3000), 2), 0.2 * hz_w(3000)};
  const Eigen::ArrayXd both = (ring_response(low, 1, ring_bins, ring_rate_hz).exp() +
                               ring_response(high, 1, ring_bins, ring_rate_hz).exp())
                                  .log();
  EXPECT_NEAR(hz_of(strongest_ring(both, 1, ring_rate_hz), 1), 1000, 30);
}

TEST(Resonance, RespondsAsTheRingOfEq13WithItsKAndC) {
  const std::vector<Resonance> one{{.natural_hz = 2000, .damping_ratio = 0.05, .height = -3}};
  const signal::DynamicParameters ring = ring_of(one, 2.0);
  // k = M w^2 and c = 2 zeta sqrt(k M), with w = 2 pi 2000.
  const double w = 2 * std::numbers::pi * 2000;
  EXPECT_NEAR(ring.stiffness_n_per_m, 2 * w * w, 1);
  EXPECT_NEAR(ring.damping_ns_per_m, 2 * 0.05 * std::sqrt(ring.stiffness_n_per_m * 2), 1e-6);
  const Eigen::ArrayXd response = ring_response(ring, 2.0, 513, 12000);
  const Eigen::ArrayXd ours = amplitude(one, 513, 12000);
  const double apart = std::log(ours[100]) - response[100];
  for (Eigen::Index i = 1; i < 513; ++i) {
    ASSERT_NEAR(std::log(ours[i]) - response[i], apart, 1e-9) << i;
  }
  // At the natural frequency the amplitude equals `height`: 2 zeta / |2 i zeta| times the height.
  EXPECT_NEAR(amplitude(one, 13, 12000)[4], 3, 1e-9);
}

TEST(Resonance, TakesTheHighestPeakForItsKAndC) {
  const std::vector<Resonance> two{{.natural_hz = 1000, .damping_ratio = 0.02, .height = 1},
                                   {.natural_hz = 3000, .damping_ratio = 0.02, .height = -2}};
  EXPECT_NEAR(std::sqrt(ring_of(two, 1).stiffness_n_per_m) / 2 / std::numbers::pi, 3000, 1e-6);
}

}  // namespace
}  // namespace piae::impacts

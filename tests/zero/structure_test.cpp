#include "zero/structure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "transfer/ring.hpp"

namespace piae::zero {
namespace {

TEST(ZeroStructure, DrawsResonancesWithinItsRanges) {
  std::size_t fewest = 100;
  std::size_t most = 0;
  for (int i = 0; i < 300; ++i) {
    Stream random("resonances " + std::to_string(i));
    const std::vector<Resonance> drawn = draw_resonances({}, 12000, random);
    fewest = std::min(fewest, drawn.size());
    most = std::max(most, drawn.size());
    for (const Resonance& one : drawn) {
      EXPECT_GE(one.natural_hz, 600 - 1e-9);
      EXPECT_LE(one.natural_hz, 5700 + 1e-9);
      EXPECT_GE(one.damping_ratio, 0.01 - 1e-12);
      EXPECT_LE(one.damping_ratio, 0.08 + 1e-12);
    }
  }
  EXPECT_EQ(fewest, 2U);
  EXPECT_EQ(most, 6U);
  Stream random("one");
  EXPECT_EQ(draw_resonances({.resonances = 1}, 12000, random).size(), 1U);
}

TEST(ZeroStructure, AnswersAsTheRingOfEq13WithItsKAndC) {
  const std::vector<Resonance> one{{.natural_hz = 2000, .damping_ratio = 0.05, .height = -3}};
  const signal::DynamicParameters ring = ring_of(one, 2.0);
  // k = M w^2 and c = 2 zeta sqrt(k M), with w = 2 pi 2000.
  const double w = 2 * std::numbers::pi * 2000;
  EXPECT_NEAR(ring.stiffness_n_per_m, 2 * w * w, 1);
  EXPECT_NEAR(ring.damping_ns_per_m, 2 * 0.05 * std::sqrt(ring.stiffness_n_per_m * 2), 1e-6);
  const Eigen::ArrayXd answer = transfer::ring_answer(ring, 2.0, 513, 12000);
  const Eigen::ArrayXd ours = amplitude(one, 513, 12000);
  const double apart = std::log(ours[100]) - answer[100];
  for (Eigen::Index i = 1; i < 513; ++i) {
    ASSERT_NEAR(std::log(ours[i]) - answer[i], apart, 1e-9) << i;
  }
  // At the natural frequency it is as high as it says, 2 zeta / |2 i zeta| times the height.
  EXPECT_NEAR(amplitude(one, 13, 12000)[4], 3, 1e-9);
}

TEST(ZeroStructure, TakesTheHighestPeakForItsKAndC) {
  const std::vector<Resonance> two{{.natural_hz = 1000, .damping_ratio = 0.02, .height = 1},
                                   {.natural_hz = 3000, .damping_ratio = 0.02, .height = -2}};
  EXPECT_NEAR(std::sqrt(ring_of(two, 1).stiffness_n_per_m) / 2 / std::numbers::pi, 3000, 1e-6);
}

TEST(ZeroStructure, IsColouredByThePowerOfTheHealthySpectrum) {
  const std::vector<Resonance> one{{.natural_hz = 2000, .damping_ratio = 0.05, .height = 1}};
  const Prior bare{.healthy_structure = 1, .path_db = 0};
  const Eigen::ArrayXd flat = Eigen::ArrayXd::Zero(513);
  const Eigen::ArrayXd slope = Eigen::ArrayXd::LinSpaced(513, -0.5, 0.5);
  Stream random("colour");
  Stream again("colour");
  Stream same("colour");
  const double power = same.uniform(0, 1);
  const Eigen::ArrayXd coloured = draw_log_answer(one, slope, 12000, bare, random) -
                                  draw_log_answer(one, flat, 12000, bare, again);
  // Apart from the least amplitude, 1e-4 of the largest, which is some 20 times the smallest.
  for (Eigen::Index i = 0; i < 513; i += 64) EXPECT_NEAR(coloured[i], power * slope[i], 3e-3);
}

}  // namespace
}  // namespace piae::zero

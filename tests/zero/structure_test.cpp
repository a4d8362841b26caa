#include "zero/structure.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace piae::zero {
namespace {

TEST(ZeroStructure, DrawsResonancesWithinItsRanges) {
  std::size_t fewest = 100;
  std::size_t most = 0;
  for (int i = 0; i < 300; ++i) {
    Stream random("resonances " + std::to_string(i));
    const std::vector<impacts::Resonance> drawn = draw_resonances({}, 12000, random);
    fewest = std::min(fewest, drawn.size());
    most = std::max(most, drawn.size());
    for (const impacts::Resonance& one : drawn) {
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

TEST(ZeroStructure, IsColouredByThePowerOfTheHealthySpectrum) {
  const std::vector<impacts::Resonance> one{
      {.natural_hz = 2000, .damping_ratio = 0.05, .height = 1}};
  const Prior bare{.healthy_structure = 1, .path_db = 0};
  const Eigen::ArrayXd flat = Eigen::ArrayXd::Zero(513);
  const Eigen::ArrayXd slope = Eigen::ArrayXd::LinSpaced(513, -0.5, 0.5);
  Stream random("colour");
  Stream again("colour");
  Stream same("colour");
  const double power = same.uniform(0, 1);
  const Eigen::ArrayXd coloured = draw_log_response(one, slope, 12000, bare, random) -
                                  draw_log_response(one, flat, 12000, bare, again);
  // The tolerance allows for the least amplitude, 1e-4 of the largest, which is about 20 times the
  // smallest.
  for (Eigen::Index i = 0; i < 513; i += 64) EXPECT_NEAR(coloured[i], power * slope[i], 3e-3);
}

}  // namespace
}  // namespace piae::zero

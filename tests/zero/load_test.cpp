#include "zero/load.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bearing/load_zone.hpp"

namespace piae::zero {
namespace {

constexpr double turn = 2 * std::numbers::pi;
const bearing::Speeds speeds_of_6205 = bearing::speeds({}, 1800);

Load drawn(bearing::Defect defect, const Prior& prior, int i) {
  Stream random("load " + std::to_string(i));
  return draw_load(defect, speeds_of_6205, prior, random);
}

TEST(LoadOfADefect, OfTheInnerRaceComesAndGoesWithTheShaft) {
  const Load load = drawn(bearing::Defect::inner, {.least_extent = 0.5, .largest_extent = 0.5}, 0);
  // Half a turn is loaded, and 30 turns are a second. The mean of q over a turn is
  // Beta(1.25, 0.5) / (2 pi) = 0.2782.
  double sum = 0;
  int loaded = 0;
  for (int i = 0; i < 30000; ++i) {
    const double share = load.at(i / 30000.0);
    sum += share;
    loaded += share > 0 ? 1 : 0;
    ASSERT_NEAR(load.at(i / 30000.0 + 1.0 / 30), share, 1e-6);
  }
  EXPECT_NEAR(loaded, 15000, 60);
  EXPECT_NEAR(sum / 30000, 0.2782, 1e-3);
}

TEST(LoadOfADefect, OfTheOuterRaceStaysWhereItIs) {
  const Prior still{.rotating = 0};
  double widest = 0;
  for (int i = 0; i < 300; ++i) {
    const Load load = drawn(bearing::Defect::outer, still, i);
    EXPECT_EQ(load.at(0), load.at(0.0123));
    EXPECT_NEAR(load.at(0), bearing::load_share(load.angle_rad, load.extent), 1e-12);
    EXPECT_GE(load.extent, 0.3);
    EXPECT_LE(load.extent, 1.5);
    widest = std::max(widest, std::abs(load.angle_rad));
  }
  EXPECT_LE(widest, 0.6);
  EXPECT_GT(widest, 0.58);
}

TEST(LoadOfADefect, OfTheOuterRaceIsModulatedByALoadThatTurns) {
  bool shown = false;
  for (int i = 0; i < 50; ++i) {
    const Load load = drawn(bearing::Defect::outer, {.rotating = 0.5}, i);
    double least = load.at(0);
    double most = least;
    for (int k = 1; k < 1000; ++k) {
      least = std::min(least, load.at(k / 30000.0));
      most = std::max(most, load.at(k / 30000.0));
    }
    EXPECT_NEAR((most - least) / (most + least), load.rotating, 1e-4);
    EXPECT_LE(load.rotating, 0.5);
    shown = shown || load.rotating > 0.3;
  }
  EXPECT_TRUE(shown);
}

TEST(LoadOfADefect, OfABallTurnsWithTheCage) {
  const Load load = drawn(bearing::Defect::roller, {.rotating = 0}, 0);
  // The cage of a 6205 makes (1 - 7.94 / 39) / 2 turns in one of the shaft.
  const double cage_s = 1 / (30 * (1 - 7.94 / 39) / 2);
  for (int i = 0; i < 50; ++i) {
    EXPECT_NEAR(load.at(0.001 * i), load.at(0.001 * i + cage_s), 1e-9);
  }
  EXPECT_NEAR(load.rad_per_s, turn / cage_s, 1e-9);
}

TEST(LoadOfADefect, MakesStrikesAlikeWithoutZoneTurningLoadAndScatter) {
  const Prior alike{.load_zone = Switch::off, .rotating = 0, .strength_scatter = 0};
  for (const auto defect :
       {bearing::Defect::inner, bearing::Defect::outer, bearing::Defect::roller}) {
    std::vector<transfer::Strike> strikes(40);
    for (std::size_t i = 0; i < 40; ++i) strikes[i].time_s = 0.003 * static_cast<double>(i);
    Stream random("alike");
    apply_load(drawn(defect, alike, 1), alike, random, strikes);
    for (const auto& strike : strikes) EXPECT_EQ(strike.strength, 1);
  }
}

TEST(LoadOfADefect, ScattersTheLogarithmOfStrengths) {
  const Prior scattered{.load_zone = Switch::off, .rotating = 0, .strength_scatter = 0.6};
  std::vector<transfer::Strike> strikes(5000);
  Stream random("scatter");
  Stream same("scatter");
  const double expected = same.uniform(0, 1) * 0.6;
  apply_load(drawn(bearing::Defect::inner, scattered, 1), scattered, random, strikes);
  double squares = 0;
  for (const auto& strike : strikes) squares += std::pow(std::log(strike.strength), 2);
  EXPECT_NEAR(std::sqrt(squares / 5000), expected, 0.04 * expected);
}

}  // namespace
}  // namespace piae::zero

#include "impacts/strengths.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace piae::impacts {
namespace {

using std::numbers::pi;

TEST(LoadZone, IsHalfATurnWithoutClearance) {
  EXPECT_DOUBLE_EQ(load_share(0, 0.5), 1);
  EXPECT_NEAR(load_share(pi / 3, 0.5), std::pow(0.5, 1.5), 1e-15);  // cos^1.5 there
  EXPECT_NEAR(load_share(pi / 2, 0.5), 0, 1e-15);
  EXPECT_EQ(load_share(pi, 0.5), 0);
}

TEST(LoadZone, IsNarrowerWithClearanceAndFullWithPreload) {
  EXPECT_EQ(load_share(pi / 2, 0.25), 0);
  EXPECT_NEAR(load_share(pi / 3, 0.3), std::pow(1 - 0.5 / 0.6, 1.5), 1e-15);
  EXPECT_NEAR(load_share(pi, 2), std::pow(0.5, 1.5), 1e-15);
}

TEST(LoadZone, IsSymmetricAboutTheLoad) {
  for (const double angle : {0.2, 0.9, 1.4}) {
    EXPECT_DOUBLE_EQ(load_share(angle, 0.4), load_share(-angle, 0.4));
    EXPECT_NEAR(load_share(angle, 0.4), load_share(angle + 2 * pi, 0.4), 1e-14);
  }
}

constexpr double revolution = 2 * pi;
const bearing::Speeds speeds_of_6205 = bearing::speeds({}, 1800);

TEST(LoadOnADefect, InnerRaceLoadFollowsTheShaft) {
  Load load = load_on(bearing::Defect::inner, speeds_of_6205, 0.5);
  load.extent = 0.5;
  // Half a turn is loaded, and the shaft makes 30 turns a second. The mean of q over a turn is
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

TEST(LoadOnADefect, OuterRaceLoadIsModulatedByARotatingLoad) {
  Load load = load_on(bearing::Defect::outer, speeds_of_6205, 0.5);
  load.extent = 1;
  load.angle_rad = 0.4;
  EXPECT_NEAR(load.at(0), 1.5 * load_share(0.4, 1), 1e-12);
  EXPECT_NEAR(load.at(1.0 / 60), 0.5 * load_share(0.4, 1), 1e-12);  // half a turn of the shaft
}

TEST(LoadOnADefect, BallLoadFollowsTheCage) {
  Load load = load_on(bearing::Defect::roller, speeds_of_6205, 0);
  load.extent = 0.5;
  // The cage of a 6205 makes (1 - 7.94 / 39) / 2 turns per shaft turn.
  const double cage_s = 1 / (30 * (1 - 7.94 / 39) / 2);
  for (int i = 0; i < 50; ++i) {
    EXPECT_NEAR(load.at(0.001 * i), load.at(0.001 * i + cage_s), 1e-9);
  }
  EXPECT_NEAR(load.rad_per_s, revolution / cage_s, 1e-9);
}

TEST(LoadOnADefect, WithoutZoneRotationAndScatterImpactsAreEqual) {
  for (const auto defect :
       {bearing::Defect::inner, bearing::Defect::outer, bearing::Defect::roller}) {
    std::vector<Impact> impacts(40);
    for (std::size_t i = 0; i < 40; ++i) impacts[i].time_s = 0.003 * static_cast<double>(i);
    Stream random("alike");
    apply_load(load_on(defect, speeds_of_6205, 0), 0, random, impacts);
    for (const Impact& impact : impacts) EXPECT_EQ(impact.strength, 1);
  }
}

TEST(LoadOnADefect, ScattersTheLogarithmOfStrengths) {
  std::vector<Impact> impacts(5000);
  Stream random("scatter");
  apply_load({}, 0.4, random, impacts);
  double squares = 0;
  for (const Impact& impact : impacts) squares += std::pow(std::log(impact.strength), 2);
  EXPECT_NEAR(std::sqrt(squares / 5000), 0.4, 0.04 * 0.4);
}

TEST(Strengths, EverySecondImpactIsWeaker) {
  std::vector<Impact> impacts(5);
  weaken_every_second(0.25, 1, impacts);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(impacts[i].strength, i % 2 == 1 ? 0.25 : 1);
}

}  // namespace
}  // namespace piae::impacts

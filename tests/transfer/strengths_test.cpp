#include "transfer/strengths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bearing/impact_frequency.hpp"

namespace piae::transfer {
namespace {

const bearing::Geometry skf_6205{.balls = 9,
                                 .ball_diameter_mm = 7.94,
                                 .pitch_diameter_mm = 39,
                                 .inner_raceway_mm = 31.06,
                                 .outer_raceway_mm = 46.94,
                                 .contact_angle_deg = 0};

std::vector<double> strengths_of(bearing::Defect fault_type, const impacts::LoadOptions& options,
                                 std::size_t count, const std::string& name = "strengths") {
  Stream random(name);
  return load_zone_strengths(fault_type, bearing::speeds(skf_6205, 1200),
                             1 / bearing::impact_frequency_hz(skf_6205, fault_type, 1200), count,
                             options, random);
}

TEST(Strengths, OuterRaceImpactsAreEqualUnderAConstantLoad) {
  for (const double one :
       strengths_of(bearing::Defect::outer, {.least_extent = 0.2, .largest_extent = 1}, 30)) {
    EXPECT_EQ(one, 1);
  }
}

TEST(Strengths, BallImpactsFollowTheCageAndAreStrongerOnOneRace) {
  const impacts::LoadOptions all_round{.least_extent = 500, .largest_extent = 500};
  const std::vector<double> all = strengths_of(bearing::Defect::roller, all_round, 40);
  for (std::size_t i = 2; i < all.size(); ++i) EXPECT_NEAR(all[i], all[i - 2], 0.01);
  EXPECT_NEAR(all[0], 1, 0.01);
  EXPECT_LT(all[1], 1);
  EXPECT_GE(all[1], 0);
}

TEST(Strengths, ScatterByTheirLogarithm) {
  impacts::LoadOptions scattered;
  scattered.scatter = 1;
  double most = 0;
  for (int w = 0; w < 200; ++w) {
    const std::vector<double> all =
        strengths_of(bearing::Defect::outer, scattered, 400, "window " + std::to_string(w));
    double squares = 0;
    for (const double one : all) squares += std::log(one) * std::log(one);
    most = std::max(most, std::sqrt(squares / 400));
  }
  EXPECT_NEAR(most, 1, 0.12);  // the largest of 200 that are uniform up to 1
}

TEST(Strengths, KnownStrengthsKeepTheirOrder) {
  Stream random("known");
  const std::vector<double> known{0.5, 1, 1.5};
  const std::vector<double> all = repeated_strengths(known, 20, random);
  ASSERT_EQ(all.size(), 20U);
  std::size_t at = 0;
  while (known[at] != all[0]) ++at;
  for (const double one : all) EXPECT_EQ(one, known[at++ % 3]);
}

TEST(Strengths, ShortWindowOutsideTheZoneIsNotSilent) {
  const impacts::LoadOptions narrow{.least_extent = 0.05, .largest_extent = 0.05};
  for (int w = 0; w < 50; ++w) {
    EXPECT_GT(strengths_of(bearing::Defect::inner, narrow, 1, "short " + std::to_string(w))[0], 0);
  }
}

}  // namespace
}  // namespace piae::transfer

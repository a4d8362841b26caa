#include "inspection/plausibility.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/random.hpp"

namespace piae::inspection {
namespace {

TEST(Speed, BetweenOneAndAHundredLooksLikeHz) {
  EXPECT_TRUE(looks_like_hz(29.95));
  EXPECT_TRUE(looks_like_hz(1));
  EXPECT_TRUE(looks_like_hz(100));
  EXPECT_FALSE(looks_like_hz(1797));
  EXPECT_FALSE(looks_like_hz(101));
}

/// SKF 6205: bore 25, outside diameter 52, shoulders about 33.8 and 44 mm.
TEST(Raceways, AcceptTheWorkingBearing) {
  EXPECT_FALSE(raceway_mismatch({}));
  EXPECT_FALSE(raceway_mismatch({9, 7.94, 39.04, 31.1, 46.9, 0})) << "rounded";
}

TEST(Raceways, AreTooWideForBoreAndOutsideDiameter) {
  const auto found = raceway_mismatch({9, 7.94, 39, 25, 52, 0});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->too_wide);
  EXPECT_FALSE(found->too_tight);
  EXPECT_DOUBLE_EQ(found->gap_mm, 13.5);
  EXPECT_DOUBLE_EQ(found->mean_mm, 38.5);
}

TEST(Raceways, AreTooTightForShoulders) {
  const auto found = raceway_mismatch({9, 7.94, 39, 33.8, 44, 0});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->too_tight);
  EXPECT_FALSE(found->too_wide);
}

TEST(Raceways, DoNotFitAwayFromThePitch) {
  const auto found = raceway_mismatch({9, 7.94, 39, 33.06, 48.94, 0});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->too_wide || found->too_tight);
  EXPECT_DOUBLE_EQ(found->mean_mm, 41);
}

/// 40 degrees: the balls touch at D -+ d cos 40 = 39 -+ 6.08 mm.
TEST(Raceways, AcceptTheContactPointsOfAnAngularBearing) {
  EXPECT_FALSE(raceway_mismatch({9, 7.94, 39, 32.92, 45.08, 40}));
  EXPECT_FALSE(raceway_mismatch({9, 7.94, 39, 31.06, 46.94, 40}));
  EXPECT_TRUE(raceway_mismatch({9, 7.94, 39, 32.92, 45.08, 0}));
}

/// At stride 512 one window on either side overlaps. All 5 training windows of the other 599 miss
/// both with the probability (597 596 595 594 593) / (599 598 597 596 595).
TEST(Overlap, OfTestAndTrainingMatchesTheClosedForm) {
  EXPECT_EQ(share_that_meets_training(1024, 1024, 600, 5), 0);
  EXPECT_NEAR(share_that_meets_training(512, 1024, 600, 5), 1 - 594.0 * 593 / (599.0 * 598), 1e-12);
  EXPECT_EQ(share_that_meets_training(1, 1024, 600, 5), 1);
}

/// Assigned as in split(), away from the ends of the record.
TEST(Overlap, OfTestAndTrainingMatchesADeal) {
  constexpr std::size_t stride = 100;
  Stream stream("overlap");
  int met = 0;
  constexpr int deals = 4000;
  for (int deal = 0; deal < deals; ++deal) {
    const std::vector<std::size_t> order = stream.permutation(600);
    bool meets = false;
    for (std::size_t known = 100; known < 105; ++known) {
      const std::size_t one = order[known];
      constexpr std::size_t tested = 300;
      const std::size_t apart = (one > tested ? one - tested : tested - one) * stride;
      meets = meets || (apart > 0 && apart < 1024);
    }
    met += meets ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(met) / deals, share_that_meets_training(stride, 1024, 600, 5),
              0.02);
}

}  // namespace
}  // namespace piae::inspection

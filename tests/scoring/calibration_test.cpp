#include "scoring/calibration.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace piae::scoring {
namespace {

/// By hand, in four bins: two predictions up to 0.5, one of them correct; three above 0.75, two of
/// them correct; none between.
const std::vector<Judgement> five{{0.4, true}, {0.5, false}, {0.8, true}, {0.9, true}, {1, false}};

TEST(Reliability, PutsEachScoreIntoTheBinWithItsUpperEdgeAtOrAboveIt) {
  const std::vector<ScoreBin> bins = reliability(five, 4);
  ASSERT_EQ(bins.size(), 4U);
  EXPECT_EQ(bins[0].count, 0U);
  EXPECT_EQ(bins[1].count, 2U);
  EXPECT_EQ(bins[2].count, 0U);
  EXPECT_EQ(bins[3].count, 3U);
  EXPECT_DOUBLE_EQ(bins[1].from, 0.25);
  EXPECT_DOUBLE_EQ(bins[1].to, 0.5);
  EXPECT_NEAR(bins[1].mean_score, 0.45, 1e-12);
  EXPECT_NEAR(bins[1].accuracy, 0.5, 1e-12);
  EXPECT_NEAR(bins[3].mean_score, 0.9, 1e-12);
  EXPECT_NEAR(bins[3].accuracy, 2 / 3.0, 1e-12);
}

TEST(Reliability, AcceptsScoresAtAndBeyondTheEnds) {
  const std::vector<ScoreBin> bins =
      reliability(std::vector<Judgement>{{0, false}, {-1e-9, false}, {1 + 1e-7, true}}, 2);
  EXPECT_EQ(bins[0].count, 2U);
  EXPECT_EQ(bins[1].count, 1U);
}

TEST(CalibrationError, WeighsTheDistanceInEachBinByItsCount) {
  const double expected = 2 / 5.0 * 0.05 + 3 / 5.0 * (0.9 - 2 / 3.0);
  EXPECT_NEAR(expected_calibration_error(reliability(five, 4)), expected, 1e-12);
}

TEST(CalibrationError, NeedsAPrediction) {
  EXPECT_THROW(expected_calibration_error(reliability({}, 4)), std::logic_error);
}

}  // namespace
}  // namespace piae::scoring

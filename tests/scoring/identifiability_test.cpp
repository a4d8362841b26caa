#include "scoring/identifiability.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace piae::scoring {
namespace {

using Values = std::vector<double>;

TEST(Agreement, IsPerfectForTheTruthItself) {
  const Values truth{1, 2, 4};
  const Agreement perfect = agreement(truth, truth);
  EXPECT_DOUBLE_EQ(perfect.r2, 1);
  EXPECT_DOUBLE_EQ(perfect.bias, 0);
  EXPECT_DOUBLE_EQ(perfect.correlation2, 1);
}

// By hand: deviations of the truth -2 -1 0 1 2, sum of squares 10; errors 1 0 -1 1 1, sum of
// squares 4, mean 0.4; inferred 2 2 2 5 6, deviations -1.4 -1.4 -1.4 1.6 2.6, squares 15.2;
// products 2.8 + 1.4 + 0 + 1.6 + 5.2 = 11.
TEST(Agreement, EqualsAHandWorkedTable) {
  const Agreement found = agreement(Values{1, 2, 3, 4, 5}, Values{2, 2, 2, 5, 6});
  EXPECT_NEAR(found.r2, 0.6, 1e-12);
  EXPECT_NEAR(found.bias, 0.4 / 3, 1e-12);
  EXPECT_NEAR(found.correlation2, 121 / 152.0, 1e-12);
}

TEST(Agreement, IsZeroIfAllInferredValuesAreTheMean) {
  const Agreement found = agreement(Values{1, 2, 3}, Values{2, 2, 2});
  EXPECT_DOUBLE_EQ(found.r2, 0);
  EXPECT_DOUBLE_EQ(found.correlation2, 0);
}

TEST(Agreement, NeedsVaryingTrueValues) {
  EXPECT_THROW(agreement(Values{2, 2}, Values{1, 2}), std::logic_error);
}

TEST(Scatter, GroupsByTheTruthAndTakesQuantiles) {
  const Values truth{6, 1, 2, 5, 3, 4};
  const Values inferred{60, 10, 30, 50, 20, 40};
  const std::vector<ScatterRow> rows = scatter(truth, inferred, 2);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].truth_low, 1);
  EXPECT_EQ(rows[0].truth_high, 3);
  EXPECT_EQ(rows[0].count, 3U);
  EXPECT_NEAR(rows[0].inferred_p10, 12, 1e-12);  // 10, 20, 30: 0.2 of the way to the second
  EXPECT_NEAR(rows[0].inferred_p50, 20, 1e-12);
  EXPECT_NEAR(rows[0].inferred_p90, 28, 1e-12);
  EXPECT_NEAR(rows[1].inferred_p50, 50, 1e-12);
}

TEST(Scatter, HasNoMoreGroupsThanValues) {
  EXPECT_EQ(scatter(Values{2, 1}, Values{2, 1}, 10).size(), 2U);
}

}  // namespace
}  // namespace piae::scoring

#include "scoring/ranks.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace piae::scoring {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Ranks, AreAscendingAndAveragedForTies) {
  EXPECT_THAT(ranks(std::vector<double>{30, 10, 20}), ElementsAre(3, 1, 2));
  EXPECT_THAT(ranks(std::vector<double>{5, 1, 5, 5, 9}), ElementsAre(3, 1, 3, 3, 5));
  EXPECT_THAT(ranks(std::vector<double>{2, 2}), ElementsAre(1.5, 1.5));
  EXPECT_THAT(ranks(std::vector<double>{}), IsEmpty());
}

/// 0.3 - 0.2 and 0.2 - 0.1 differ in binary.
TEST(Ranks, TreatRoundingDifferencesAsTies) {
  ASSERT_NE(0.3 - 0.2, 0.2 - 0.1);
  EXPECT_THAT(ranks(std::vector<double>{0.3 - 0.2, 2, 0.2 - 0.1}), ElementsAre(1.5, 3, 1.5));
  EXPECT_THAT(ranks(std::vector<double>{0.5, 0.5001}), ElementsAre(1, 2));
}

/// Demsar 2006, Table 6: AUC of four variants of C4.5 on 14 data sets; a value printed as 0.975
/// twice with different ranks has one more digit here. Average ranks, F = 3.69 and critical
/// difference 1.25 as on his pages 12 and 13; p from an F table: F(3, 39) is 2.85 at 0.05 and 4.33
/// at 0.01.
TEST(AverageRanks, MatchTheWorkedExample) {
  const AverageRanks c = average_ranks({{0.763, 0.768, 0.771, 0.798},
                                        {0.599, 0.591, 0.590, 0.569},
                                        {0.954, 0.971, 0.968, 0.967},
                                        {0.628, 0.661, 0.654, 0.657},
                                        {0.882, 0.888, 0.886, 0.898},
                                        {0.936, 0.931, 0.916, 0.931},
                                        {0.661, 0.668, 0.609, 0.685},
                                        {0.583, 0.583, 0.563, 0.625},
                                        {0.775, 0.838, 0.866, 0.875},
                                        {1.000, 1.000, 1.000, 1.000},
                                        {0.940, 0.962, 0.965, 0.962},
                                        {0.619, 0.666, 0.614, 0.669},
                                        {0.972, 0.981, 0.9752, 0.975},
                                        {0.957, 0.978, 0.946, 0.970}});
  EXPECT_EQ(c.blocks, 14U);
  ASSERT_EQ(c.average.size(), 4U);
  EXPECT_NEAR(c.average[0], 3.143, 5e-4);
  EXPECT_NEAR(c.average[1], 2.000, 5e-4);
  EXPECT_NEAR(c.average[2], 2.893, 5e-4);
  EXPECT_NEAR(c.average[3], 1.964, 5e-4);
  EXPECT_NEAR(*c.critical_difference, 1.25, 5e-3);
  EXPECT_GT(*c.p, 0.01);
  EXPECT_LT(*c.p, 0.05);
  // F = 3.69 with (3, 39) degrees of freedom, by numerical integration of the density.
  EXPECT_NEAR(*c.p, 0.0198, 3e-4);
}

/// Demsar 2006, Table 5a.
TEST(AverageRanks, HaveTheQuantilesOfThePublishedTable) {
  const double at_005[] = {1.960, 2.343, 2.569, 2.728, 2.850, 2.949, 3.031, 3.102, 3.164};
  const double at_010[] = {1.645, 2.052, 2.291, 2.459, 2.589, 2.693, 2.780, 2.855, 2.920};
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(nemenyi_quantile(i + 2, 0.05), at_005[i], 1.1e-3) << i + 2 << " methods";
    EXPECT_NEAR(nemenyi_quantile(i + 2, 0.10), at_010[i], 1.1e-3) << i + 2 << " methods";
  }
}

TEST(AverageRanks, PValueIsLimitedByTheNumberOfOrders) {
  const AverageRanks agree = average_ranks({{3, 2, 1}, {30, 20, 10}});
  EXPECT_THAT(agree.average, ElementsAre(1, 2, 3));
  EXPECT_NEAR(*agree.p, 1.0 / 6, 1e-12);  // one of six orders
  EXPECT_NEAR(*average_ranks({{2, 1}, {2, 1}, {2, 1}, {2, 1}, {2, 1}}).p, 1.0 / 16, 1e-12);
  const AverageRanks alike = average_ranks({{5, 5, 5}, {7, 7, 7}});
  EXPECT_THAT(alike.average, ElementsAre(2, 2, 2));
  EXPECT_EQ(alike.p, 1);
}

TEST(AverageRanks, OneBlockOrOneMethodGivesNoTest) {
  const AverageRanks one_block = average_ranks({{1, 2}});
  EXPECT_THAT(one_block.average, ElementsAre(2, 1));
  EXPECT_EQ(one_block.p, std::nullopt);
  EXPECT_EQ(one_block.critical_difference, std::nullopt);
  EXPECT_EQ(average_ranks({{1}, {2}}).p, std::nullopt);
  EXPECT_THROW(average_ranks({}), std::logic_error);
  EXPECT_THROW(average_ranks({{1, 2}, {1}}), std::logic_error);
}

}  // namespace
}  // namespace piae::scoring

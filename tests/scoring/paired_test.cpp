#include "scoring/paired.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace piae::scoring {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;
using Values = std::vector<double>;

/// Returns the two-sided p from all 2^n choices of signs, for ranks worked by hand.
double p_by_counting(const Values& ranks, double smaller) {
  const double all = std::accumulate(ranks.begin(), ranks.end(), 0.0);
  const auto choices = std::size_t{1} << ranks.size();
  std::size_t as_extreme = 0;
  for (std::size_t choice = 0; choice < choices; ++choice) {
    double sum = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) {
      if ((choice >> i & 1U) != 0) sum += ranks[i];
    }
    if (std::min(sum, all - sum) <= smaller) ++as_extreme;
  }
  return static_cast<double>(as_extreme) / static_cast<double>(choices);
}

/// Hollander & Wolfe 1973, pages 29 f.: Hamilton's depression scale before and after. The negative
/// differences have the ranks 2 and 3, so the statistic is 40 of 45; ten of the 512 subsets of {1,
/// ..., 9} sum to 5 or less.
TEST(SignedRanks, MatchHollanderAndWolfe) {
  const Values before{1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const Values after{0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  const PairedDifference c = paired_difference(before, after);
  EXPECT_NEAR(*c.p, 0.0390625, 1e-12);
  EXPECT_NEAR(c.rank_biserial, (40.0 - 5.0) / 45, 1e-12);
  EXPECT_NEAR(c.difference.mean, 3.887 / 9, 1e-12);
}

/// Demsar 2006, Table 2: differences of C4.5 with and without a parameter on 14 data sets. He
/// splits the ranks of the two zero differences. Without these two, all others rank two lower: the
/// negative ones are 7 and 3.5 - 2.
TEST(SignedRanks, ExcludeZeroDifferences) {
  const Values differences{0.005, -0.008, 0.017, 0.033, 0.006, -0.005, 0.007,
                           0.000, 0.063,  0.000, 0.022, 0.047, 0.009,  0.021};
  const SignedRanks test = signed_ranks(differences);
  EXPECT_EQ(test.negative, 5 + 1.5);
  EXPECT_EQ(test.positive, 71.5);
  EXPECT_NEAR(test.rank_biserial(), 65.0 / 78, 1e-12);
  EXPECT_NEAR(test.p, p_by_counting({1.5, 5, 7, 10, 3, 1.5, 4, 12, 9, 11, 6, 8}, 6.5), 1e-12);
}

/// A textbook example, with equal differences and one of zero: W = 27 - 18.
TEST(SignedRanks, AverageTheRanksOfTies) {
  const Values differences{15, -7, 5, 20, 0, -9, 17, -12, 5, -10};
  const SignedRanks test = signed_ranks(differences);
  EXPECT_EQ(test.positive, 27);
  EXPECT_EQ(test.negative, 18);
  EXPECT_NEAR(test.rank_biserial(), 0.2, 1e-12);
  EXPECT_NEAR(test.p, p_by_counting({7, 3, 1.5, 9, 4, 8, 6, 1.5, 5}, 18), 1e-12);
}

/// Published critical values (two-sided, 0.05): n = 6: 0, 8: 3, 10: 8, 12: 13. The value itself is
/// significant and the next larger one is not. These negative ranks of {1, ..., n} sum to T.
TEST(SignedRanks, MatchTabulatedCriticalValues) {
  struct Case {
    int n;
    std::vector<int> negative;
    bool significant;
  };
  const Case cases[] = {{5, {}, false},   {6, {}, true},       {6, {1}, false},
                        {8, {3}, true},   {8, {4}, false},     {10, {8}, true},
                        {10, {9}, false}, {12, {3, 10}, true}, {12, {3, 11}, false}};
  for (const Case& each : cases) {
    Values differences;
    for (int rank = 1; rank <= each.n; ++rank) {
      const bool negative = std::ranges::count(each.negative, rank) > 0;
      differences.push_back(negative ? -rank : rank);
    }
    EXPECT_EQ(signed_ranks(differences).p <= 0.05, each.significant)
        << each.n << ", p " << signed_ranks(differences).p;
  }
}

TEST(SignedRanks, AreSymmetric) {
  const Values differences{1, 2, -3, 4, 5, 6};
  Values turned;
  for (const double d : differences) turned.push_back(-d);
  EXPECT_EQ(signed_ranks(differences).p, signed_ranks(turned).p);
  EXPECT_EQ(signed_ranks(differences).rank_biserial(), -signed_ranks(turned).rank_biserial());
}

/// The mean of the statistic is n (n + 1) / 4 and its variance n (n + 1) (2 n + 1) / 24.
TEST(SignedRanks, ApproachTheNormalForManyPairs) {
  Values differences;
  for (int i = 1; i <= 60; ++i) differences.push_back(i % 3 == 0 ? -i : i);
  const SignedRanks test = signed_ranks(differences);
  const double z = (test.positive - 60 * 61 / 4.0 - 0.5) / std::sqrt(60 * 61 * 121 / 24.0);
  EXPECT_NEAR(test.p, std::erfc(z / std::sqrt(2.0)), 1e-3);
}

TEST(PairedDifference, HasNeitherIntervalNorTestForOnePair) {
  const PairedDifference c = paired_difference(Values{90}, Values{80});
  EXPECT_EQ(c.difference.mean, 10);
  EXPECT_EQ(c.difference.interval, std::nullopt);
  EXPECT_EQ(c.p, std::nullopt);
  EXPECT_EQ(c.rank_biserial, 1);
}

TEST(PairedDifference, IsZeroForEqualValues) {
  const PairedDifference c = paired_difference(Values{80, 90.1, 0.1 + 0.2}, Values{80, 90.1, 0.3});
  EXPECT_EQ(c.difference.mean, 0);
  EXPECT_EQ(c.p, 1);
  EXPECT_EQ(c.rank_biserial, 0);
}

/// Differences 2, 4, 6: mean 4, deviation 2, half width 4.30265 * 2 / sqrt(3).
TEST(PairedDifference, HasTheIntervalOfTheDifferences) {
  const PairedDifference c = paired_difference(Values{12, 24, 36}, Values{10, 20, 30});
  EXPECT_NEAR(c.difference.interval->low, 4 - 4.96827, 1e-4);
  EXPECT_NEAR(c.difference.interval->high, 4 + 4.96827, 1e-4);
  EXPECT_EQ(c.p, 0.25);
  EXPECT_THROW(paired_difference(Values{1, 2}, Values{1}), std::logic_error);
  EXPECT_THROW(paired_difference(Values{}, Values{}), std::logic_error);
}

TEST(PairedDifference, CannotBeMoreCertainThanItsPairsAllow) {
  EXPECT_EQ(smallest_p(5), 0.0625);
  EXPECT_EQ(smallest_p(10), 2.0 / 1024);
  EXPECT_EQ(signed_ranks(Values{1, 2, 3, 4, 5}).p, smallest_p(5));
}

/// By hand: 0.005 * 4, 0.01 * 3, 0.03 * 2, and 0.04 * 1, which must not be below the previous
/// value.
TEST(Holm, CorrectsFromTheSmallestPDownwards) {
  EXPECT_THAT(holm(Values{0.01, 0.04, 0.03, 0.005}),
              ElementsAre(DoubleNear(0.03, 1e-12), DoubleNear(0.06, 1e-12), DoubleNear(0.06, 1e-12),
                          DoubleNear(0.02, 1e-12)));
  EXPECT_THAT(holm(Values{0.6, 0.7}), ElementsAre(1, 1));
  EXPECT_THAT(holm(Values{0.02}), ElementsAre(0.02));
  EXPECT_THAT(holm(Values{}), IsEmpty());
}

}  // namespace
}  // namespace piae::scoring

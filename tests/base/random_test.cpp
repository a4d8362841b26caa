#include "base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace piae {
namespace {

TEST(Stream, DependsOnlyOnItsName) {
  Stream first("cwru/seed3/split");
  Stream second("cwru/seed3/split");
  for (int i = 0; i < 100; ++i) EXPECT_EQ(first.uniform(0, 1), second.uniform(0, 1));
  Stream other("cwru/seed4/split");
  EXPECT_NE(Stream("cwru/seed3/split").uniform(0, 1), other.uniform(0, 1));
}

TEST(Stream, ChildDoesNotDependOnDrawsOfItsParent) {
  Stream parent("parent");
  const double before = parent.child("x").uniform(0, 1);
  parent.normal(0, 1);
  EXPECT_EQ(parent.child("x").uniform(0, 1), before);
  EXPECT_EQ(Stream("parent/x").uniform(0, 1), before);
}

// SHA-256("abc") starts with ba7816bf8f01cfea. This test fixes the derivation forever: a change
// would silently change every result.
TEST(Stream, IsSeededWithEightBytesOfTheNamesDigest) {
  Stream stream("abc");
  boost::random::mt19937_64 engine(0xba7816bf8f01cfeaULL);
  const auto expected = static_cast<double>(engine()) / 18446744073709551616.0;
  EXPECT_NEAR(stream.uniform(0, 1), expected, 1e-15);
}

TEST(Stream, UniformAndNormalHaveTheirMoments) {
  Stream stream("moments");
  constexpr int n = 200000;
  double uniform = 0;
  double normal = 0;
  double squares = 0;
  for (int i = 0; i < n; ++i) {
    const double u = stream.uniform(2, 6);
    ASSERT_GE(u, 2);
    ASSERT_LT(u, 6);
    uniform += u;
    const double x = stream.normal(1, 3);
    normal += x;
    squares += (x - 1) * (x - 1);
  }
  EXPECT_NEAR(uniform / n, 4, 5 * std::sqrt(16.0 / 12 / n));
  EXPECT_NEAR(normal / n, 1, 5 * 3 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 9, 5 * 9 * std::sqrt(2.0 / n));
}

/// Returns the Kolmogorov distance of 10,000 draws from a distribution function; it is below 0.0195
/// in 99.9 % of cases.
double distance_of_beta(double alpha, double beta, const std::function<double(double)>& expected) {
  Stream stream("beta");
  constexpr int n = 10'000;
  std::vector<double> draws(n);
  for (double& draw : draws) draw = stream.beta(alpha, beta);
  std::ranges::sort(draws);
  double largest = 0;
  for (int i = 0; i < n; ++i) {
    const double below = expected(draws[static_cast<std::size_t>(i)]);
    largest = std::max(
        {largest, std::abs(below - static_cast<double>(i) / n), std::abs(below - (i + 1.0) / n)});
  }
  return largest;
}

TEST(Stream, BetaHasItsDistribution) {
  EXPECT_LT(distance_of_beta(1, 1, [](double x) { return x; }), 0.0195);
  EXPECT_LT(distance_of_beta(2, 1, [](double x) { return x * x; }), 0.0195);
  EXPECT_LT(distance_of_beta(1, 3, [](double x) { return 1 - std::pow(1 - x, 3); }), 0.0195);
  EXPECT_LT(distance_of_beta(
                0.5, 0.5, [](double x) { return 2 / std::numbers::pi * std::asin(std::sqrt(x)); }),
            0.0195);
}

TEST(Stream, BetaIsANumberForSmallShapes) {
  Stream stream("small shapes");
  double sum = 0;
  constexpr int n = 100'000;
  for (int i = 0; i < n; ++i) {
    const double draw = stream.beta(0.05, 0.05);
    ASSERT_GE(draw, 0);
    ASSERT_LE(draw, 1);
    sum += draw;
  }
  EXPECT_NEAR(sum / n, 0.5, 5 * std::sqrt(1 / (4 * 1.1) / n));  // variance 1 / (4 (2 alpha + 1))
}

TEST(Stream, PermutationHoldsEachIndexOnce) {
  Stream stream("permutation");
  std::vector<std::size_t> order = stream.permutation(600);
  EXPECT_FALSE(std::ranges::is_sorted(order));
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
  EXPECT_TRUE(stream.permutation(0).empty());
}

TEST(Stream, PermutationsOfThreeAreEquallyLikely) {
  Stream stream("three");
  std::map<std::vector<std::size_t>, int> seen;
  constexpr int draws = 60000;
  for (int i = 0; i < draws; ++i) ++seen[stream.permutation(3)];
  ASSERT_EQ(seen.size(), 6U);
  for (const auto& [order, count] : seen)
    EXPECT_NEAR(count, draws / 6.0, 5 * std::sqrt(draws / 6.0));
}

}  // namespace
}  // namespace piae

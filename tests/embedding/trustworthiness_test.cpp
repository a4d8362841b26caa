#include "embedding/trustworthiness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <vector>

#include "embedding/point_sets.hpp"
#include "embedding/reference_tsne.hpp"

namespace piae::embedding {
namespace {

using Eigen::Index;

Points on_a_line(std::initializer_list<double> values) {
  Points points(static_cast<Index>(values.size()), 1);
  std::copy(values.begin(), values.end(), points.data());
  return points;
}

/// Returns 1 plus the number of points that are nearer to i than j, or equally near with a smaller
/// index.
Index rank_of(const Points& points, Index i, Index j) {
  Index rank = 1;
  const double distance = reference::squared_distance(points, i, j);
  for (Index k = 0; k < points.rows(); ++k) {
    const double other = reference::squared_distance(points, i, k);
    if (k != i && k != j && (other < distance || (other == distance && k < j))) ++rank;
  }
  return rank;
}

double by_definition(const Points& points, const Points& map, Index k) {
  const auto n = static_cast<double>(points.rows());
  double sum = 0;
  for (Index i = 0; i < points.rows(); ++i) {
    for (Index j = 0; j < points.rows(); ++j) {
      const Index rank = i == j ? 0 : rank_of(points, i, j);
      if (rank > k && rank_of(map, i, j) <= k) sum += static_cast<double>(rank - k);
    }
  }
  const auto of = static_cast<double>(k);
  return 1 - 2 / (n * of * (2 * n - 3 * of - 1)) * sum;
}

TEST(Trustworthiness, IsOneForTheIdentity) {
  const Points points = cloud(50, 2, "points");
  EXPECT_EQ(trustworthiness(points, points), 1);
  EXPECT_EQ(trustworthiness(points, -3 * points, 5), 1);
}

/// The map puts c, at 3, between a and b. With k = 1, the nearest on the map and its rank among the
/// points is: c for a (after b: 2), c for b (after a: 2), a for c (after d, b and e: 4), e for d
/// (1), d for e (1). So the value is 1 - 2 (1 + 1 + 3) / (5 * 1 * (10 - 3 - 1)) = 1 - 10 / 30.
TEST(Trustworthiness, EqualsTheHandWorkedValue) {
  const Points points = on_a_line({0, 1, 3, 4.5, 5.5});
  const Points map = on_a_line({0, 1, 0.4, 4.5, 5.5});
  EXPECT_NEAR(trustworthiness(points, map, 1), 1 - 10.0 / 30, 1e-15);
}

/// The nearest neighbours on the map are d, d, a and a: for each point, the farthest one.
TEST(Trustworthiness, IsZeroIfEachNeighbourIsTheFarthest) {
  const Points points = on_a_line({0, 0.1, 10, 10.1});
  const Points map = on_a_line({0, 2.5, -1.5, 1});
  EXPECT_NEAR(trustworthiness(points, map, 1), 0, 1e-15);
}

TEST(Trustworthiness, MatchesTheDefinition) {
  const Points points = cloud(60, 5, "points");
  const Points map = points.leftCols(2) + 0.5 * cloud(60, 2, "map");
  for (const Index k : {1, 5, 12, 29}) {
    EXPECT_NEAR(trustworthiness(points, map, k), by_definition(points, map, k), 1e-14);
  }
  EXPECT_EQ(trustworthiness(points, map), trustworthiness(points, map, 12));
}

/// On a grid of whole numbers most distances occur more than once.
TEST(Trustworthiness, BreaksTiesByIndex) {
  Points points(36, 2);
  for (Index i = 0; i < 36; ++i) {
    const Index row = i / 6;
    points.row(i) << static_cast<double>(row), static_cast<double>(i % 6);
  }
  const Points map = points.rowwise().sum();
  for (const Index k : {1, 4, 12}) {
    EXPECT_NEAR(trustworthiness(points, map, k), by_definition(points, map, k), 1e-14);
  }
}

TEST(Trustworthiness, IsAboutAHalfForARandomMap) {
  EXPECT_NEAR(trustworthiness(cloud(400, 5, "points"), cloud(400, 2, "map")), 0.5, 0.03);
}

TEST(Trustworthiness, RefusesMismatchedMaps) {
  const Points points = cloud(24, 3, "points");
  EXPECT_THROW(trustworthiness(points, cloud(23, 2, "map"), 5), std::logic_error);
  EXPECT_THROW(trustworthiness(points, points, 0), std::logic_error);
  EXPECT_THROW(trustworthiness(points, points, 12), std::logic_error);
  EXPECT_THROW(trustworthiness(points, std::nan("") * points, 5), std::logic_error);
  EXPECT_EQ(trustworthiness(points, points, 11), 1);
}

}  // namespace
}  // namespace piae::embedding

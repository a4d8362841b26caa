#include "embedding/points.hpp"

#include <gtest/gtest.h>

#include "embedding/point_sets.hpp"
#include "embedding/reference_tsne.hpp"

namespace piae::embedding {
namespace {

TEST(SquaredDistances, AreSumsOfSquaredDifferences) {
  const Points points = cloud(20, 7, "points");
  const Eigen::MatrixXd distances = squared_distances(points);
  for (Eigen::Index i = 0; i < 20; ++i) {
    for (Eigen::Index j = 0; j < 20; ++j) {
      EXPECT_NEAR(distances(i, j), reference::squared_distance(points, i, j), 1e-12);
    }
  }
  EXPECT_EQ(distances, distances.transpose());
}

/// Computing distances by a matrix product would leave the rounding error of 1e16 - 1e16.
TEST(SquaredDistances, AreZeroForEqualDistantPoints) {
  const Points points = Points::Constant(3, 5, 1e8 / 3);
  EXPECT_TRUE(squared_distances(points).isZero(0));
}

}  // namespace
}  // namespace piae::embedding

#include "embedding/start.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "embedding/point_sets.hpp"

namespace piae::embedding {
namespace {

double deviation(const Eigen::ArrayXd& values) {
  return std::sqrt((values - values.mean()).square().mean());
}

/// Points on a known ellipse in space: axes of 10 and 2 along (3, 4, 0) / 5 and (0, 0, -1), about
/// (100, 200, 300). Their standard deviations are the axes over sqrt(2), whose ratio is 5.
TEST(FirstPlaces, AreTheFirstTwoPrincipalComponents) {
  constexpr Eigen::Index n = 40;
  Points points(n, 3);
  Plane expected(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / n;
    points.row(i) << 100 + 6 * std::cos(angle), 200 + 8 * std::cos(angle),
        300 - 2 * std::sin(angle);
    // The largest loading of the second component must be positive, so it points along (0, 0, 1).
    expected.row(i) << 1e-4 * std::sqrt(2) * std::cos(angle),
        -1e-4 * std::sqrt(2) * std::sin(angle) / 5;
  }
  EXPECT_TRUE((first_places(points) - expected).isZero(1e-13));
}

TEST(FirstPlaces, FollowReorderedPoints) {
  const Points points = three_clouds(30, 4, 5, "points");
  const Plane places = first_places(points);
  EXPECT_TRUE(first_places(points.colwise().reverse()).isApprox(places.colwise().reverse(), 1e-9));
}

TEST(FirstPlaces, AreNoiseAlongADirectionWithoutVariation) {
  Points points(20, 3);
  for (Eigen::Index i = 0; i < 20; ++i) {
    points.row(i) = Eigen::RowVector3d::LinSpaced(1, 3) * static_cast<double>(i);
  }
  for (const Points& line : {points, Points(points.leftCols(1))}) {
    const Plane places = first_places(line);
    EXPECT_NEAR(deviation(places.col(0)), 1e-4, 1e-12);
    EXPECT_GT(deviation(places.col(1)), 1e-7);
    EXPECT_LT(deviation(places.col(1)), 1e-5);
    EXPECT_TRUE((places == first_places(line)).all());
  }
}

TEST(FirstPlaces, AreNoiseForEqualPoints) {
  const Plane places = first_places(Points::Constant(20, 3, 7));
  EXPECT_TRUE(places.allFinite());
  EXPECT_GT(deviation(places.col(0)), 1e-7);
  EXPECT_GT(deviation(places.col(1)), 1e-7);
  EXPECT_LT(places.abs().maxCoeff(), 1e-5);
}

}  // namespace
}  // namespace piae::embedding

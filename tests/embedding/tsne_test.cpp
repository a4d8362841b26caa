#include "embedding/tsne.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "base/error.hpp"
#include "embedding/point_sets.hpp"
#include "embedding/reference_tsne.hpp"
#include "embedding/trustworthiness.hpp"

namespace piae::embedding {
namespace {

using Eigen::Index;

TEST(Tsne, ReportsTheDivergenceOfItsMap) {
  const Points points = three_clouds(90, 8, 4, "points");
  const TsneMap map = tsne(points, {.perplexity = 15});
  const double expected =
      reference::kl_divergence(reference::pair_probabilities(points, 15), map.points);
  EXPECT_NEAR(map.kl_divergence, expected, 1e-8);
}

/// At the minimum, the reference cost rises in every direction.
TEST(Tsne, EndsAtTheMinimumOfTheCost) {
  const Points points = three_clouds(60, 8, 4, "points");
  TsneMap map = tsne(points, {.perplexity = 10, .iterations = 2000});
  const reference::Table p = reference::pair_probabilities(points, 10);
  for (Index i = 0; i < 60; i += 3) {
    for (Index axis = 0; axis < 2; ++axis) {
      for (const double distance : {-0.3, 0.3}) {
        Points moved = map.points;
        moved(i, axis) += distance;
        EXPECT_GT(reference::kl_divergence(p, moved), map.kl_divergence);
      }
    }
  }
}

/// Each point is nearer to all points of its own cloud than to any of another cloud.
TEST(Tsne, SeparatesClouds) {
  const Points points = three_clouds(150, 20, 30, "points");
  const TsneMap map = tsne(points, {.perplexity = 30});
  const Eigen::MatrixXd distances = squared_distances(map.points);
  for (Index i = 0; i < 150; ++i) {
    double own = 0;
    double other = std::numeric_limits<double>::infinity();
    for (Index j = 0; j < 150; ++j) {
      if (i % 3 == j % 3) {
        own = std::max(own, distances(i, j));
      } else {
        other = std::min(other, distances(i, j));
      }
    }
    EXPECT_LT(own, other) << "point " << i;
  }
  EXPECT_GT(trustworthiness(points, map.points), 0.9);
}

/// A rolled-up sheet has a map as good as that of the flat sheet.
TEST(Tsne, UnrollsASheet) {
  Stream stream("sheet");
  Points points(300, 3);
  for (Index i = 0; i < 300; ++i) {
    const double angle = stream.uniform(M_PI, 3 * M_PI);
    points.row(i) << angle * std::cos(angle), stream.uniform(0, 10), angle * std::sin(angle);
  }
  EXPECT_GT(trustworthiness(points, tsne(points, {.perplexity = 20}).points), 0.99);
}

TEST(Tsne, IsReproducibleForAnyNumberOfThreads) {
  const Points points = three_clouds(203, 10, 3, "points");
  const auto with_threads = [&](int count) {
    const Threads held(count);
    return tsne(points, {.iterations = 400});
  };
  const TsneMap one = with_threads(1);
  for (const int threads : {1, 2, 4}) {
    const TsneMap again = with_threads(threads);
    EXPECT_EQ(one.points, again.points) << threads << " threads";
    EXPECT_EQ(one.kl_divergence, again.kl_divergence) << threads << " threads";
  }
}

TEST(Tsne, ReorderedPointsGiveTheReorderedMap) {
  const Points points = three_clouds(90, 8, 6, "points");
  Eigen::PermutationMatrix<Eigen::Dynamic> order(90);
  const std::vector<std::size_t> indices = Stream("order").permutation(90);
  std::ranges::copy(indices, order.indices().begin());
  const TsneMap map = tsne(points, {.perplexity = 15});
  const TsneMap reordered = tsne(order * points, {.perplexity = 15});
  EXPECT_EQ(reordered.points, order * map.points);
  EXPECT_EQ(reordered.kl_divergence, map.kl_divergence);
}

TEST(Tsne, AcceptsEqualPoints) {
  Points points = three_clouds(60, 5, 8, "points");
  for (Index i = 0; i < 30; ++i) points.row(30 + i) = points.row(i % 3);
  const TsneMap map = tsne(points, {.perplexity = 8});
  EXPECT_TRUE(map.points.allFinite());
  EXPECT_TRUE(std::isfinite(map.kl_divergence));
  EXPECT_GT(trustworthiness(points, map.points), 0.8);
}

TEST(Tsne, IgnoresAConstantCoordinate) {
  Points points = three_clouds(60, 5, 8, "points");
  const TsneMap without = tsne(points, {.perplexity = 8, .iterations = 20});
  points.conservativeResize(Eigen::NoChange, 7);
  points.col(5).setConstant(1e3);
  points.col(6).setZero();
  const TsneMap with = tsne(points, {.perplexity = 8, .iterations = 20});
  EXPECT_TRUE(with.points.isApprox(without.points, 1e-3));
}

/// All pairs are equally probable, and all are near each other on the map: no information is lost.
TEST(Tsne, EqualPointsLoseNothing) {
  const TsneMap map = tsne(Points::Constant(50, 4, 3.5), {.perplexity = 10});
  EXPECT_TRUE(map.points.allFinite());
  EXPECT_NEAR(map.kl_divergence, 0, 1e-3);
}

TEST(Tsne, PointsOnALineLeaveTheLine) {
  Points points(100, 2);
  for (Index i = 0; i < 100; ++i) points.row(i) << static_cast<double>(i), 2.0;
  const TsneMap map = tsne(points, {.perplexity = 20});
  EXPECT_TRUE(map.points.allFinite());
  EXPECT_GT(map.points.col(1).cwiseAbs().maxCoeff(), 0.1);
  EXPECT_GT(trustworthiness(points, map.points), 0.99);
}

TEST(Tsne, AcceptsTheFewestPoints) {
  const TsneMap map = tsne(cloud(5, 3, "points"), {.perplexity = 1});
  EXPECT_TRUE(map.points.allFinite());
  EXPECT_LT(map.points.cwiseAbs().maxCoeff(), 1e4);
}

TEST(Tsne, RefusesAPerplexityTooLargeForThePoints) {
  const Points points = cloud(31, 3, "points");
  EXPECT_THROW(tsne(points, {.perplexity = 10, .iterations = 1}), std::logic_error);
  EXPECT_NO_THROW(tsne(points, {.perplexity = 9.9, .iterations = 1}));
  for (const double bad : {0.9, -1.0, std::nan("")}) {
    EXPECT_THROW(tsne(points, {.perplexity = bad}), std::logic_error) << bad;
  }
  for (const Index few : {0, 1, 3, 4}) {
    EXPECT_THROW(tsne(cloud(few, 3, "points"), {.perplexity = 1}), std::logic_error) << few;
  }
}

TEST(Tsne, RefusesPointsWithoutAMap) {
  EXPECT_THROW(tsne(Points(50, 0), {.perplexity = 5}), std::logic_error);
  EXPECT_THROW(tsne(cloud(50, 3, "points"), {.perplexity = 5, .exaggeration = 0}),
               std::logic_error);
}

TEST(Tsne, NamesThePointThatIsNotFinite) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Points points = cloud(50, 3, "points");
    points(17, 2) = bad;
    try {
      tsne(points, {.perplexity = 5});
      FAIL() << "a coordinate of " << bad << " was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::bad_input);
      EXPECT_THAT(error.what(), testing::HasSubstr("point 17"));
    }
  }
}

}  // namespace
}  // namespace piae::embedding

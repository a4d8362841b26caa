#include "embedding/tsne_cost.hpp"

#include <gtest/gtest.h>

#include "embedding/neighbours.hpp"
#include "embedding/point_sets.hpp"
#include "embedding/reference_tsne.hpp"
#include "support/differences.hpp"

namespace piae::embedding {
namespace {

constexpr Eigen::Index count = 75;  // not a multiple of the length of a vector or of a block
constexpr double perplexity = 12;

struct TsneCost : testing::Test {
  Points points = three_clouds(count, 6, 4, "points");
  Eigen::MatrixXd probabilities = pair_probabilities(squared_distances(points), perplexity);
  reference::Table expected = reference::pair_probabilities(points, perplexity);
};

TEST_F(TsneCost, MatchesTheDefinition) {
  for (const double size : {1e-4, 1.0, 30.0}) {
    const Points map = size * cloud(count, 2, "map");
    EXPECT_NEAR(kl_divergence(probabilities, map), reference::kl_divergence(expected, map), 1e-8);
  }
}

/// The differences use the cost of the reference, so both sides are independent.
TEST_F(TsneCost, HasTheGradientOfFiniteDifferences) {
  const KlGradient gradient_at(probabilities);
  for (const double size : {0.01, 1.0, 10.0}) {
    Points map = size * cloud(count, 2, "map");
    const Plane gradient = gradient_at(map);
    const double largest = gradient.abs().maxCoeff();
    for (Eigen::Index i = 0; i < count; i += 7) {
      for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double slope = central_difference(
            map(i, axis), 1e-4 * size, [&] { return reference::kl_divergence(expected, map); });
        EXPECT_NEAR(gradient(i, axis), slope, 2e-5 * largest) << "a map of size " << size;
      }
    }
  }
}

/// The gradient is linear in the probabilities: exaggeration e adds (e - 1) times the attraction.
TEST_F(TsneCost, ExaggerationIncreasesAttraction) {
  const KlGradient gradient_at(probabilities);
  const Plane map = cloud(count, 2, "map");
  const Plane repulsion = gradient_at(map, 0);
  const Plane attraction = gradient_at(map, 1) - repulsion;
  const Plane exaggerated = gradient_at(map, 12);
  EXPECT_TRUE(exaggerated.isApprox(12 * attraction + repulsion, 1e-12));
}

/// Four points so far apart that the rounding of 1 + w dominates.
TEST_F(TsneCost, HasTheGradientOfDistantPoints) {
  const Eigen::MatrixXd equal =
      (Eigen::MatrixXd::Ones(4, 4) - Eigen::MatrixXd::Identity(4, 4)) / 12;
  Points map(4, 2);
  map << 0, 0, 40, 5, -10, 60, 70, -80;
  const reference::Table table(4, std::vector<double>(4, 1.0 / 12));
  const Plane gradient = KlGradient(equal)(map);
  for (Eigen::Index i = 0; i < 4; ++i) {
    const double slope =
        central_difference(map(i, 0), 1e-3, [&] { return reference::kl_divergence(table, map); });
    EXPECT_NEAR(gradient(i, 0), slope, 1e-3 * gradient.abs().maxCoeff());
  }
}

/// Enough points that a step runs on several threads.
TEST_F(TsneCost, DoesNotDependOnTheNumberOfThreads) {
  const Points many = cloud(1100, 5, "many");
  const Plane map = cloud(1100, 2, "map");
  const auto both = [&](int threads) {
    const Threads held(threads);
    const Eigen::MatrixXd p = pair_probabilities(squared_distances(many), perplexity);
    return std::pair(kl_divergence(p, map), KlGradient(p)(map));
  };
  const auto [one_cost, one_gradient] = both(1);
  const auto [four_cost, four_gradient] = both(4);
  EXPECT_EQ(one_cost, four_cost);
  EXPECT_TRUE((one_gradient == four_gradient).all());
}

}  // namespace
}  // namespace piae::embedding

#include "embedding/neighbours.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "embedding/point_sets.hpp"
#include "embedding/reference_tsne.hpp"

namespace piae::embedding {
namespace {

double perplexity_of(const Eigen::ArrayXd& p) {
  return reference::perplexity_of(std::vector<double>(p.begin(), p.end()));
}

TEST(NeighbourProbabilities, HaveTheRequestedPerplexity) {
  Stream stream("distances");
  Eigen::ArrayXd distances(200);
  for (double& distance : distances) distance = std::pow(stream.normal(0, 1), 2);
  for (const double perplexity : {1.0, 1.5, 5.0, 30.0, 66.0}) {
    for (const double unit : {1e-30, 1.0, 1e30}) {
      const Eigen::ArrayXd p = neighbour_probabilities(unit * distances, perplexity);
      EXPECT_NEAR(p.sum(), 1, 1e-12);
      EXPECT_NEAR(perplexity_of(p), perplexity, 1e-7 * perplexity) << "distances times " << unit;
    }
  }
}

/// ln(p_j / p_k) = beta (d_k - d_j), with the same beta for all pairs.
TEST(NeighbourProbabilities, AreGaussian) {
  Eigen::ArrayXd distances(9);
  distances << 3, 1, 2, 5, 4, 2.5, 1.5, 6, 7;
  const Eigen::ArrayXd p = neighbour_probabilities(distances, 2.5);
  const double beta = std::log(p[1] / p[0]) / 2;
  EXPECT_GT(beta, 0);
  for (Eigen::Index j = 0; j < 9; ++j) {
    EXPECT_NEAR(std::log(p[1] / p[j]), beta * (distances[j] - 1), 1e-12);
  }
}

TEST(NeighbourProbabilities, FindTheNearestAmongDistantPoints) {
  Eigen::ArrayXd distances = Eigen::ArrayXd::Constant(10, 1e12);
  distances[4] = 1e-12;
  const Eigen::ArrayXd p = neighbour_probabilities(distances, 1);
  EXPECT_NEAR(p[4], 1, 1e-8);
}

TEST(NeighbourProbabilities, AreSharedEquallyAmongEqualPoints) {
  Eigen::ArrayXd distances = Eigen::ArrayXd::Constant(12, 3);
  distances.head(6) = 0;
  const Eigen::ArrayXd p = neighbour_probabilities(distances, 2);
  EXPECT_TRUE(p.head(6).isApproxToConstant(1.0 / 6, 1e-12));
  EXPECT_TRUE(p.tail(6).isZero(1e-12));
  EXPECT_TRUE(neighbour_probabilities(Eigen::ArrayXd::Zero(12), 2).isApproxToConstant(1.0 / 12));
}

TEST(PairProbabilities, MatchTheDefinition) {
  const Points points = three_clouds(60, 5, 3, "points");
  const Eigen::MatrixXd p = pair_probabilities(squared_distances(points), 10);
  const reference::Table expected = reference::pair_probabilities(points, 10);
  for (Eigen::Index i = 0; i < 60; ++i) {
    for (Eigen::Index j = 0; j < 60; ++j) {
      EXPECT_NEAR(p(i, j), expected[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)],
                  1e-9);
    }
  }
  EXPECT_NEAR(p.sum(), 1, 1e-12);
  EXPECT_EQ(p, p.transpose());
  EXPECT_TRUE(p.diagonal().isZero(0));
}

}  // namespace
}  // namespace piae::embedding

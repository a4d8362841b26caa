#include "symptoms/novelty.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace piae::symptoms {
namespace {

/// Returns 12 windows of 5 bands: sin(3 i + j^2), and in band 2 a drift of 0.1 i.
Eigen::ArrayXXd drifting() {
  Eigen::ArrayXXd shapes(12, 5);
  for (Eigen::Index i = 0; i < 12; ++i) {
    for (Eigen::Index j = 0; j < 5; ++j) {
      shapes(i, j) = std::sin(static_cast<double>(3 * i + j * j)) +
                     (j == 2 ? 0.1 * static_cast<double>(i) : 0);
    }
  }
  return shapes;
}

// Computed with numpy from the same equation (np.mean, np.var and np.std over all rows, and over
// those of three blocks of four).
TEST(Novelty, IsTheDistanceOverTheLargestLeftOutHealthyDistance) {
  const Novelty novelty(drifting());
  const double of_healthy[] = {0.833333, 0.40657,  0.63588,  0.372691, 0.323399, 0.378941,
                               0.507824, 0.389024, 0.634335, 0.629652, 0.758934, 0.689635};
  for (Eigen::Index i = 0; i < 12; ++i) {
    EXPECT_NEAR(novelty.of_healthy()[i], of_healthy[i], 1e-6) << i;
  }
  Eigen::ArrayXd other(5);
  other << 1, 2, 3, 4, 5;
  EXPECT_NEAR(novelty.of(other), 2.455436, 1e-6);
  EXPECT_NEAR(novelty.of(drifting().row(3).transpose()), 0.346562, 1e-6);
}

TEST(Novelty, IsFiniteForIdenticalWindows) {
  const Novelty novelty(Eigen::ArrayXXd::Constant(8, 5, 2.0));
  EXPECT_EQ(novelty.of(Eigen::ArrayXd::Constant(5, 2.0)), 0);
  EXPECT_GT(novelty.of(Eigen::ArrayXd::Constant(5, 2.1)), 1);
  EXPECT_TRUE(std::isfinite(novelty.of(Eigen::ArrayXd::Constant(5, 2.1))));
}

}  // namespace
}  // namespace piae::symptoms

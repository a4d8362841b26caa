#include "scoring/mmd.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <stdexcept>

#include "scoring/sets.hpp"

namespace piae::scoring {
namespace {

Windows column(std::initializer_list<double> values) {
  Windows windows(static_cast<Eigen::Index>(values.size()), 1);
  std::copy(values.begin(), values.end(), windows.data());
  return windows;
}

TEST(MeanSquaredDistance, ExcludesPairsOfAWindowWithItself) {
  EXPECT_NEAR(mean_squared_distance(column({0, 2, 5})), (4.0 + 25 + 9) / 3, 1e-12);
}

TEST(MeanSquaredDistance, NeedsTwoWindows) {
  EXPECT_THROW(mean_squared_distance(column({1})), std::logic_error);
}

/// Squared distances: 0 and 4 within {0, 2} and within {1, 3}; 1, 9, 1, 1 between them. With b = 4
/// the five kernels add up to 5, 4.554440, 3.575121 and 2.623489 at 0, 1, 4 and 9, and (2 (2 * 5 +
/// 2 * 3.575121) - 2 (3 * 4.554440 + 2.623489)) / 4 = 0.431716.
TEST(Mmd, EqualsTheHandWorkedValue) {
  EXPECT_NEAR(mmd_squared(column({0, 2}), column({1, 3}), 16), 0.431715631975, 1e-11);
}

TEST(Mmd, IsZeroForIdenticalSets) {
  const Windows x = noise(100, 16, "x");
  EXPECT_NEAR(mmd_squared(x, x, mean_squared_distance(x)), 0, 1e-12);
}

/// The sets are so far apart that all kernels vanish: only pairs of a window with itself count.
TEST(Mmd, IsTenOverNForDistantPoints) {
  const Windows x = column({0, 1e6, 2e6, 3e6});
  const Windows y = column({5e5, 15e5, 25e5, 35e5});
  EXPECT_NEAR(mmd_squared(x, y, 1), 2.0 * 5 * 4 / 16, 1e-12);
}

double kernel(const Eigen::RowVectorXd& difference, double bandwidth) {
  double sum = 0;
  for (const double m : {1, 2, 4, 8, 16}) {
    sum += std::exp(-difference.squaredNorm() / (bandwidth * m));
  }
  return sum;
}

/// More rows than a block has, and not a multiple.
TEST(Mmd, MatchesItsDefinitionForManyWindows) {
  const Windows x = noise(150, 20, "x");
  const Windows y = noise(150, 20, "y") * 1.5;
  const double squared_distance = mean_squared_distance(y);
  double sum = 0;
  double distances = 0;
  for (Eigen::Index i = 0; i < 150; ++i) {
    for (Eigen::Index j = 0; j < 150; ++j) {
      sum += kernel(x.row(i) - x.row(j), squared_distance / 4) +
             kernel(y.row(i) - y.row(j), squared_distance / 4) -
             2 * kernel(x.row(i) - y.row(j), squared_distance / 4);
      distances += (y.row(i) - y.row(j)).squaredNorm();
    }
  }
  EXPECT_NEAR(squared_distance, distances / (150 * 149), 1e-9);
  EXPECT_NEAR(mmd_squared(x, y, squared_distance), sum / (150 * 150), 1e-11);
}

TEST(Mmd, DoesNotDependOnTheNumberOfThreads) {
  const Windows x = noise(200, 64, "x");
  const Windows y = noise(200, 64, "y");
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const double one = mmd_squared(x, y, mean_squared_distance(y));
  omp_set_num_threads(3);
  const double three = mmd_squared(x, y, mean_squared_distance(y));
  omp_set_num_threads(before);
  EXPECT_EQ(one, three);
}

TEST(Mmd, RefusesSetsOfDifferentSize) {
  EXPECT_THROW(mmd_squared(column({0, 2}), column({1}), 1), std::logic_error);
  EXPECT_THROW(mmd_squared(noise(2, 3, "x"), noise(2, 4, "y"), 1), std::logic_error);
  EXPECT_THROW(mmd_squared(Windows(0, 4), Windows(0, 4), 1), std::logic_error);
  EXPECT_THROW(mmd_squared(column({0, 2}), column({1, 3}), 0), std::logic_error);
  EXPECT_THROW(mmd_squared(column({0, 2}), column({1, 3}), std::nan("")), std::logic_error);
}

}  // namespace
}  // namespace piae::scoring

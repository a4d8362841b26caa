#include <gtest/gtest.h>

#include <vector>

#include "report/accuracies.hpp"

namespace piae::report {
namespace {

scoring::Summary of(const std::vector<double>& values, const Bounds& bounds = percents) {
  return summarise_within(bounds, values);
}

/// Values 40, 50, 60: deviation 10, half-width of the interval 4.302653 * 10 / sqrt(3) = 24.8414.
TEST(BoundedSummary, KeepsAPossibleInterval) {
  const scoring::Summary summary = of({40, 50, 60});
  EXPECT_EQ(summary.count, 3U);
  EXPECT_DOUBLE_EQ(summary.mean, 50);
  EXPECT_DOUBLE_EQ(*summary.deviation, 10);
  EXPECT_NEAR(summary.interval->low, 25.1586, 1e-4);
  EXPECT_NEAR(summary.interval->high, 74.8414, 1e-4);
}

TEST(BoundedSummary, CutsOffImpossibleMeans) {
  EXPECT_DOUBLE_EQ(of({80, 90, 100}).interval->high, 100);
  EXPECT_NEAR(of({80, 90, 100}).interval->low, 65.1586, 1e-4);
  EXPECT_DOUBLE_EQ(of({0, 10, 20}).interval->low, 0);
  EXPECT_NEAR(of({0, 10, 20}, differences_of_percents).interval->low, -14.8414, 1e-4);
  EXPECT_DOUBLE_EQ(of({-100, 0, 100}, differences_of_percents).interval->low, -100);
  EXPECT_DOUBLE_EQ(of({-100, 0, 100}, differences_of_percents).interval->high, 100);
}

/// The intervals would be 0.7 to 64.3 for 30 and 35, and -331 to 431 for 20 and 80.
TEST(BoundedSummary, HasNoIntervalForFewerThanThreeSeeds) {
  EXPECT_FALSE(of({30, 35}).interval);
  EXPECT_FALSE(of({20, 80}).interval);
  EXPECT_FALSE(of({20}).interval);
  EXPECT_TRUE(of({30, 35}).deviation);
}

}  // namespace
}  // namespace piae::report

#include "phase/states.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace piae::phase {
namespace {

// Class 1: log k = 0 and 2, mean 1, deviation 1; log c = 1 and 1, no spread. Class 2: one point.
TEST(StateScale, RemovesClassMeanAndSpreadFromLogarithms) {
  const std::vector<twin::TwinPoint> points{{1, std::exp(1)}, {std::exp(2), std::exp(1)}, {5, 7}};
  const std::vector<std::int32_t> labels{1, 1, 2};
  const StateScale scale(points, labels, 3);
  const auto standardised = scale.standardised(points, labels);
  EXPECT_NEAR(standardised[0].k, -1, 1e-12);
  EXPECT_NEAR(standardised[1].k, 1, 1e-12);
  EXPECT_NEAR(standardised[0].c, 0, 1e-12);
  EXPECT_NEAR(standardised[2].k, 0, 1e-12);
  EXPECT_NEAR(scale.standardised({std::exp(4), std::exp(1.5)}, 1).k, 3, 1e-12);
  EXPECT_NEAR(scale.standardised({std::exp(4), std::exp(1.5)}, 1).c, 0.5, 1e-12);
}

}  // namespace
}  // namespace piae::phase

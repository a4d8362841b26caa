#include "twin/networks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace piae::twin {
namespace {

// softplus(x) = log(1 + exp(x)), and its slope is 1 / (1 + exp(-x)).
TEST(Networks, SoftplusSlopeIsAccurateForSmallValues) {
  for (const double x : {-60.0, -30.0, -20.0, -10.0, -3.0, 0.0, 3.0, 30.0}) {
    RowArray<float> k_and_c(1, 2);
    k_and_c << static_cast<float>(std::log1p(std::exp(x))), 1.0F;
    const double expected = 1 / (1 + std::exp(-x));
    const RowArray<float> slope = slope_at(k_and_c, Positive::softplus);
    EXPECT_NEAR(slope(0, 0), expected, 4e-7 * expected) << x;
    EXPECT_NEAR(slope(0, 1), 1 - std::exp(-1.0), 4e-7);
  }
}

TEST(Networks, ExponentialSlopeEqualsItsValue) {
  RowArray<float> k_and_c(1, 2);
  k_and_c << 0.25F, 3.0F;
  EXPECT_TRUE((slope_at(k_and_c, Positive::exponential) == k_and_c).all());
}

}  // namespace
}  // namespace piae::twin

#include "zero/draws.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace piae::zero {
namespace {

constexpr int many_draws = 20000;

TEST(Draws, FromARangeOfOneNumberReturnIt) {
  Stream random("one");
  EXPECT_EQ(evenly(random, 3, 3), 3);
  EXPECT_EQ(log_evenly(random, 3, 3), 3);
  EXPECT_EQ(log_evenly(random, 0, 0), 0);
}

TEST(Draws, AreUniformInTheLogarithm) {
  Stream random("log");
  double logarithms = 0;
  int below_one = 0;
  for (int i = 0; i < many_draws; ++i) {
    const double one = log_evenly(random, 0.1, 100);
    ASSERT_GE(one, 0.1);
    ASSERT_LT(one, 100);
    logarithms += std::log10(one);
    below_one += one < 1 ? 1 : 0;
  }
  // Three decades: the mean of the logarithm is 0.5, with a standard error of 3 / sqrt(12 n) =
  // 0.006. A third of the draws are in the first decade.
  EXPECT_NEAR(logarithms / many_draws, 0.5, 0.025);
  EXPECT_NEAR(below_one, many_draws / 3.0, 270);
}

TEST(Draws, OccurWithTheirProbability) {
  Stream random("chance");
  int happened = 0;
  for (int i = 0; i < many_draws; ++i) happened += bernoulli(random, 0.3) ? 1 : 0;
  EXPECT_NEAR(happened, 0.3 * many_draws, 260);  // four standard deviations of 65
  EXPECT_FALSE(bernoulli(random, 0));
  EXPECT_TRUE(bernoulli(random, 1));
}

TEST(Draws, PoissonVarianceEqualsItsMean) {
  Stream random("poisson");
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < many_draws; ++i) {
    const auto count = static_cast<double>(poisson(random, 2));
    sum += count;
    squares += count * count;
  }
  const double mean = sum / many_draws;
  EXPECT_NEAR(mean, 2, 0.04);
  EXPECT_NEAR(squares / many_draws - mean * mean, 2, 0.1);
}

}  // namespace
}  // namespace piae::zero

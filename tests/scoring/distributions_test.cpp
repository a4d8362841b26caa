#include "scoring/distributions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace piae::scoring {
namespace {

TEST(Distributions, NormalMatchesTables) {
  EXPECT_NEAR(normal_density(0), 1 / std::sqrt(2 * std::numbers::pi), 1e-15);
  EXPECT_NEAR(normal_below(1.959963984540054), 0.975, 1e-14);
  EXPECT_NEAR(normal_above(3), 1.3498980316301e-3, 1e-16);
}

TEST(Distributions, StudentMatchesTables) {
  EXPECT_NEAR(student_t_exceeded_with(0.025, 9), 2.262157, 1e-6);
  EXPECT_NEAR(student_t_exceeded_with(0.025, 1), std::tan(0.475 * std::numbers::pi), 1e-10);
}

TEST(Distributions, FisherWithTwoAndTwoDegreesMatchesItsClosedForm) {
  for (const double f : {0.1, 1.0, 7.0}) EXPECT_NEAR(fisher_f_above(f, 2, 2), 1 / (1 + f), 1e-14);
}

}  // namespace
}  // namespace piae::scoring

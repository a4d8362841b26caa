#include "scoring/auroc.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace piae::scoring {
namespace {

// The positive value is greater in five of the six pairs (negative, positive), and less in one:
// (3, 2).
TEST(Auroc, IsTheShareOfPairsInWhichThePositiveIsHigher) {
  EXPECT_DOUBLE_EQ(auroc(std::vector{1.0, 3.0}, std::vector{2.0, 4.0, 5.0}), 5.0 / 6);
  EXPECT_DOUBLE_EQ(auroc(std::vector{3.0, 1.0}, std::vector{5.0, 2.0, 4.0}), 5.0 / 6);
}

// Two of the six pairs are equal; in three the positive value is greater.
TEST(Auroc, CountsTiesHalf) {
  EXPECT_DOUBLE_EQ(auroc(std::vector{1.0, 2.0, 2.0}, std::vector{2.0, 3.0}), (1 + 2 * 0.5 + 3) / 6);
  EXPECT_DOUBLE_EQ(auroc(std::vector{7.0, 7.0}, std::vector{7.0}), 0.5);
}

TEST(Auroc, IsOneOrZeroIfAllPairsAgree) {
  const std::vector<double> low{-3, -2};
  const std::vector<double> high{0, 1, 1};
  EXPECT_DOUBLE_EQ(auroc(low, high), 1);
  EXPECT_DOUBLE_EQ(auroc(high, low), 0);
}

TEST(Auroc, NeedsPositivesAndNegatives) {
  const std::vector<double> none;
  const std::vector<double> some{1};
  EXPECT_THROW((void)auroc(none, some), std::logic_error);
  EXPECT_THROW((void)auroc(some, none), std::logic_error);
}

}  // namespace
}  // namespace piae::scoring

#include "figures/thinning.hpp"

#include <gtest/gtest.h>

namespace piae::figures {
namespace {

Eigen::ArrayXd seven_numbers() {
  Eigen::ArrayXd numbers(7);
  numbers << 1, -5, 2, 8, 8, 0, -3;
  return numbers;
}

TEST(Thinning, KeepsTheExtremesOfEachGroup) {
  const Thinning thinning(7, 3);  // three, three and one
  ASSERT_EQ(thinning.groups(), 3);
  EXPECT_TRUE((thinning.highest(seven_numbers()) == Eigen::Array3d(2, 8, -3)).all());
  EXPECT_TRUE((thinning.lowest(seven_numbers()) == Eigen::Array3d(-5, 0, -3)).all());
}

TEST(Thinning, ComputesTheMiddlesOfItsGroups) {
  const Thinning thinning(7, 3);
  EXPECT_EQ(thinning.middle(0), 1);
  EXPECT_EQ(thinning.middle(1), 4);
  EXPECT_EQ(thinning.middle(2), 6);
  EXPECT_EQ(Thinning(8, 4).middle(1), 2.5);
}

TEST(Thinning, DoesNotChangeFewNumbers) {
  const Thinning thinning(7, 128);
  ASSERT_EQ(thinning.groups(), 7);
  EXPECT_TRUE((thinning.highest(seven_numbers()) == seven_numbers()).all());
  EXPECT_TRUE((thinning.lowest(seven_numbers()) == seven_numbers()).all());
  EXPECT_EQ(thinning.middle(6), 6);
}

}  // namespace
}  // namespace piae::figures

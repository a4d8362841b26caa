#include "symptoms/bands.hpp"

#include <gtest/gtest.h>

namespace piae::symptoms {
namespace {

TEST(NarrowBands, AreNineUpTo6300HzOrAsManyAsTheRateHolds) {
  const std::vector<Band> bands = narrow_bands(12000);
  ASSERT_EQ(bands.size(), 9U);
  EXPECT_EQ(bands.front().low_hz, 300);
  EXPECT_EQ(bands.front().high_hz, 1500);
  EXPECT_EQ(bands.back().low_hz, 5100);
  EXPECT_EQ(bands.back().high_hz, 6300);
  EXPECT_EQ(narrow_bands(51200).size(), 9U);
  EXPECT_EQ(narrow_bands(6000).size(), 4U);  // with middles at 900, 1500, 2100 and 2700 Hz
  EXPECT_EQ(narrow_bands(1800).size(), 1U);
  EXPECT_TRUE(narrow_bands(1799).empty());
}

// sin^2 of 45 degrees is a half.
TEST(Response, IsOneWithinAHalfAtTheEdgesAndZeroOutside) {
  const Eigen::ArrayXd passed = response({.low_hz = 300, .high_hz = 1500}, 241, 25);
  EXPECT_NEAR(passed[300 / 25], 0.5, 1e-12);
  EXPECT_NEAR(passed[1500 / 25], 0.5, 1e-12);
  EXPECT_NEAR(passed[325 / 25], 0.853553, 1e-6);  // sin^2 of 67.5 degrees
  EXPECT_EQ(passed[900 / 25], 1);
  EXPECT_EQ(passed[350 / 25], 1);
  EXPECT_EQ(passed[250 / 25], 0);
  EXPECT_NEAR(passed[1550 / 25], 0, 1e-12);
  EXPECT_EQ(passed[0], 0);
}

TEST(FilterBank, HasTheResponsesOfAllBandsAtTheBinsOfAWindow) {
  const FilterBank bank = filter_bank(12000, 480);
  ASSERT_EQ(bank.responses.size(), 9U);
  EXPECT_EQ(bank.rate_hz, 12000);
  const Eigen::ArrayXd second = response({.low_hz = 900, .high_hz = 2100}, 241, 25);
  EXPECT_TRUE((bank.responses[1] == second).all());
}

}  // namespace
}  // namespace piae::symptoms

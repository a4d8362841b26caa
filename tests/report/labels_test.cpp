#include "report/labels.hpp"

#include <gtest/gtest.h>

namespace piae::report {
namespace {

TEST(Labels, ShowTheSpreadIfThereIsOne) {
  const scoring::Summary one{.count = 1, .mean = 12.345, .deviation = {}, .interval = {}};
  const scoring::Summary two{2, -1.5, 0.125, scoring::Summary::Interval{-2, 3}};
  EXPECT_EQ(mean_label(one), "12.35");
  EXPECT_EQ(interval_label(one), "–");
  EXPECT_EQ(mean_label(two, {.decimals = 1, .sign = true}), "-1.5 ± 0.1");
  EXPECT_EQ(interval_label(two, {.sign = true}), "[-2.00, +3.00]");
}

TEST(Labels, ShowTheTrueRatioIfItDiffers) {
  EXPECT_EQ(ratio_label("25to1", 25), "25:1");
  EXPECT_EQ(ratio_label("2to1", 500.0 / 150), "2:1 (3.33:1)");
  EXPECT_EQ(ratio_label("100to1", 30.0 / 5), "100:1 (6:1)");
  EXPECT_EQ(ratio_label("100to1", std::nullopt), "100:1 (no faults)");
}

}  // namespace
}  // namespace piae::report

#include "bearing/impact_frequency.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace piae::bearing {
namespace {

/// Compares with the maker's frequencies of the SKF 6205 at 1797 rpm.
TEST(ImpactFrequency, HaveTheFrequencyOfTheirDefect) {
  EXPECT_NEAR(impact_frequency_hz({}, Defect::outer, 1797), 107.34, 0.005);
  EXPECT_NEAR(impact_frequency_hz({}, Defect::inner, 1797), 162.21, 0.005);
  EXPECT_NEAR(impact_frequency_hz({}, Defect::roller, 1797), 2 * 70.51, 0.01);
  EXPECT_EQ(impact_frequency_hz({}, Defect::none, 1797), 0);
}

/// A ball's centre moves past the outer race at half the speed of the inner race: (1797 / 60) pi
/// 31.06 mm / 2 = 1461 mm/s on the pitch circle of 39 mm, which is 1759 mm/s at the outer raceway.
TEST(ImpactFrequency, LastFromEdgeToEdge) {
  const double rolling_mm_per_s = 1797 / 60.0 * std::numbers::pi * 31.06 / 2;
  EXPECT_NEAR(passage_s({}, {Defect::outer, 0.5}, 1797), 0.5 / (rolling_mm_per_s * 46.94 / 39.0),
              1e-8);
  // Past the inner race the ball is slower, because the race itself moves on.
  const double inner_race_mm_per_s = 1797 / 60.0 * std::numbers::pi * 31.06;
  EXPECT_NEAR(passage_s({}, {Defect::inner, 0.5}, 1797),
              0.5 / (inner_race_mm_per_s - rolling_mm_per_s * 31.06 / 39.0), 2e-8);
  EXPECT_EQ(passage_s({}, {}, 1797), 0);
}

TEST(ImpactFrequency, AreShorterAndMoreFrequentAtAHigherSpeed) {
  for (const Defect fault_type : {Defect::outer, Defect::inner, Defect::roller}) {
    EXPECT_NEAR(passage_s({}, {fault_type, 0.5}, 600), 2 * passage_s({}, {fault_type, 0.5}, 1200),
                1e-12);
    EXPECT_NEAR(impact_frequency_hz({}, fault_type, 1200),
                2 * impact_frequency_hz({}, fault_type, 600), 1e-9);
  }
}

}  // namespace
}  // namespace piae::bearing

#include "transfer/journey.hpp"

#include <gtest/gtest.h>

#include "support/known_windows.hpp"

namespace piae::transfer {
namespace {

TEST(Journey, WithoutConditionsEndsWhereItStarted) {
  const signal::WindowSet known = known_windows();
  for (std::size_t i = 0; i < 12; ++i) {
    const Journey journey = journey_of(known, 2, i);
    EXPECT_EQ(journey.known, 5 + i % 5);
    EXPECT_EQ(journey.condition, signal::every_condition);
    EXPECT_EQ(journey.speed_ratio(), 1);
  }
  EXPECT_FALSE(arrived(known, journey_of(known, 2, 0), {}).condition);
}

/// Returns windows with faults known at 1200 and 1000 rpm and tested at 900 and 600 rpm.
signal::WindowSet known_at_two_speeds() {
  signal::WindowSet known = known_windows();
  known.info.conditions = {
      {.name = "fast", .shaft_speed_rpm = 1200, .known = true, .test = false, .healthy = true},
      {.name = "less", .shaft_speed_rpm = 1000, .known = true, .test = false, .healthy = true},
      {.name = "slow", .shaft_speed_rpm = 900, .known = false, .test = true, .healthy = true},
      {.name = "crawl", .shaft_speed_rpm = 600, .known = false, .test = true, .healthy = true}};
  known.condition.assign(known.size(), 0);
  known.shaft_speed_rpm.assign(known.size(), 1200);
  known.condition[1] = 1;
  known.shaft_speed_rpm[1] = 1000;
  return known;
}

TEST(Journey, CyclesThroughKnownWindowsAndTestedConditions) {
  const signal::WindowSet known = known_at_two_speeds();
  EXPECT_DOUBLE_EQ(journey_of(known, 1, 0).speed_ratio(), 900.0 / 1200);
  EXPECT_DOUBLE_EQ(journey_of(known, 1, 1).speed_ratio(), 900.0 / 1000);
  EXPECT_DOUBLE_EQ(journey_of(known, 1, 5).speed_ratio(), 600.0 / 1200);
  EXPECT_DOUBLE_EQ(journey_of(known, 1, 11).speed_ratio(), 900.0 / 1000);
  EXPECT_EQ(journey_of(known, 1, 5).condition, 3);
}

TEST(Journey, MadeWindowsHaveTheirTestedCondition) {
  const signal::WindowSet known = known_at_two_speeds();
  const signal::MadeWindow made = arrived(known, journey_of(known, 1, 6), {1, 2});
  EXPECT_EQ(made.samples, (std::vector<float>{1, 2}));
  EXPECT_EQ(made.condition, 3);
  EXPECT_EQ(made.shaft_speed_rpm, 600);
  EXPECT_EQ(made.parents, signal::parents_of({1}));
}

}  // namespace
}  // namespace piae::transfer

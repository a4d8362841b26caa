#include "phase/class_cycle.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/errors.hpp"
#include "support/simulated_windows.hpp"

namespace piae::phase {
namespace {

// Harris' formulas by hand for 9 balls, d / D = 7.94 / 39, 29.95 Hz: BPFI = 9/2 f (1 + d/D) =
// 162.21 Hz, BPFO = 9/2 f (1 - d/D) = 107.34 Hz, 2 BSF = f D/d (1 - (d/D)^2) = 141.01 Hz.
TEST(ClassCycle, ImpactsComeAtTheFaultFrequency) {
  signal::DatasetInfo info = bearing_info();
  EXPECT_NEAR(impact_frequency_hz(info, 1), 162.21, 0.01);
  EXPECT_NEAR(impact_frequency_hz(info, 2), 107.34, 0.01);
  info.classes[2].defect = signal::Defect::roller;
  EXPECT_NEAR(impact_frequency_hz(info, 2), 141.01, 0.02);
  EXPECT_THROW(impact_frequency_hz(info, 0), Error);
}

// One impact every 12000 / 107.34 = 111.79 samples: 8 fit in 894.4, 9 would leave only 18 of 1024.
TEST(ClassCycle, HasTheFaultFrequency) {
  const signal::Cycle cycle = cycle_of_class(bearing_info(), 2, 1024);
  EXPECT_EQ(cycle.impacts, 8U);
  EXPECT_EQ(cycle.samples, 894U);
}

TEST(ClassCycle, RefusesWindowsWithoutAWholePeriod) {
  EXPECT_ERROR(cycle_of_class(bearing_info(), 2, 100), Exit::bad_input, "OR021");
}

}  // namespace
}  // namespace piae::phase

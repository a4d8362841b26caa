#include "diagnosis/fitting_signal.hpp"

#include <gtest/gtest.h>

#include "support/errors.hpp"
#include "support/three_classes.hpp"

namespace piae::diagnosis {
namespace {

// Trained at 12 kHz and 1800 rpm.
TEST(FittingSignal, NeedsAtLeastTheTrainedSampleRate) {
  EXPECT_NO_THROW(require_fitting_signal(three_classes(), 12000, 1800, "a.csv"));
  EXPECT_NO_THROW(require_fitting_signal(three_classes(), 48000, 1800, "a.csv"));
  EXPECT_ERROR(require_fitting_signal(three_classes(), 11999, 1800, "a.csv"), Exit::bad_input,
               "a.csv: is sampled at 11999 Hz, but the classifier was trained at 12000 Hz; record "
               "at that rate or a higher one, or train a classifier at this rate");
}

TEST(FittingSignal, NeedsASpeedWithinFivePercent) {
  for (const double rpm : {1711.0, 1889.0}) {
    EXPECT_NO_THROW(require_fitting_signal(three_classes(), 12000, rpm, "a.csv")) << rpm;
  }
  for (const double rpm : {1709.0, 1891.0}) {
    EXPECT_ERROR(require_fitting_signal(three_classes(), 12000, rpm, "a.csv"), Exit::bad_input,
                 "but the classifier was trained at 1800 rpm and allows a deviation of 5 %");
  }
  EXPECT_ERROR(require_fitting_signal(three_classes(), 12000, 900, "a.csv"), Exit::bad_input,
               "a.csv: was recorded at 900 rpm");
}

// Faults are known at 900 rpm and generated for 1200; at 600 rpm only healthy windows are known.
TEST(FittingSignal, NeedsASpeedNearOneOfTheTrainedFaults) {
  signal::DatasetInfo info = three_classes();
  info.conditions = {{.name = "fast", .shaft_speed_rpm = 1200, .known = false},
                     {.name = "slow", .shaft_speed_rpm = 900, .test = false},
                     {.name = "slowest", .shaft_speed_rpm = 600, .known = false, .test = false}};
  EXPECT_NO_THROW(require_fitting_signal(info, 12000, 1190, "a.csv"));
  EXPECT_NO_THROW(require_fitting_signal(info, 12000, 930, "a.csv"));
  for (const double rpm : {1800.0, 1050.0, 600.0}) {
    EXPECT_ERROR(require_fitting_signal(info, 12000, rpm, "a.csv"), Exit::bad_input,
                 "trained at 900, 1200 rpm");
  }
}

}  // namespace
}  // namespace piae::diagnosis

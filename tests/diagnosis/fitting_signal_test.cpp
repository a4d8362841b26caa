#include "diagnosis/fitting_signal.hpp"

#include <gtest/gtest.h>

#include "diagnosis/line_rules.hpp"
#include "diagnosis/symptom_net.hpp"
#include "diagnosis/wdcnn_inputs.hpp"
#include "support/errors.hpp"
#include "support/three_classes.hpp"

namespace piae::diagnosis {
namespace {

// Trained at 12 kHz and 1800 rpm.
TEST(FittingSignal, NeedsAtLeastTheTrainedSampleRate) {
  EXPECT_NO_THROW(require_fitting_signal(wdcnn, three_classes(), 12000, 1800, "a.csv"));
  EXPECT_NO_THROW(require_fitting_signal(wdcnn, three_classes(), 48000, 1800, "a.csv"));
  EXPECT_ERROR(require_fitting_signal(wdcnn, three_classes(), 11999, 1800, "a.csv"),
               Exit::bad_input,
               "a.csv: is sampled at 11999 Hz, but the classifier was trained at 12000 Hz; record "
               "at that rate or a higher one, or train a classifier at this rate");
}

TEST(FittingSignal, NeedsASpeedWithinFivePercent) {
  for (const double rpm : {1711.0, 1889.0}) {
    EXPECT_NO_THROW(require_fitting_signal(wdcnn, three_classes(), 12000, rpm, "a.csv")) << rpm;
  }
  for (const double rpm : {1709.0, 1891.0}) {
    EXPECT_ERROR(require_fitting_signal(wdcnn, three_classes(), 12000, rpm, "a.csv"),
                 Exit::bad_input,
                 "but the classifier was trained at 1800 rpm and wdcnn judges recordings at 0.95 "
                 "to 1.05 times that speed");
  }
  EXPECT_ERROR(require_fitting_signal(wdcnn, three_classes(), 12000, 900, "a.csv"), Exit::bad_input,
               "a.csv: was recorded at 900 rpm");
}

// Faults are known at 900 rpm and generated for 1200; at 600 rpm only healthy windows are known.
TEST(FittingSignal, NeedsASpeedNearOneOfTheTrainedFaults) {
  signal::DatasetInfo info = three_classes();
  info.conditions = {{.name = "fast", .shaft_speed_rpm = 1200, .known = false},
                     {.name = "slow", .shaft_speed_rpm = 900, .test = false},
                     {.name = "slowest", .shaft_speed_rpm = 600, .known = false, .test = false}};
  EXPECT_NO_THROW(require_fitting_signal(wdcnn, info, 12000, 1190, "a.csv"));
  EXPECT_NO_THROW(require_fitting_signal(wdcnn, info, 12000, 930, "a.csv"));
  for (const double rpm : {1800.0, 1050.0, 600.0}) {
    EXPECT_ERROR(require_fitting_signal(wdcnn, info, 12000, rpm, "a.csv"), Exit::bad_input,
                 "trained at 900, 1200 rpm");
  }
}

// Lines lie at orders of the shaft.
TEST(FittingSignal, MayHaveAnotherSpeedForSymptoms) {
  for (const Classifier* const each : {&envelope_rule, &exclusion_rule, &symptom_net}) {
    EXPECT_NO_THROW(require_fitting_signal(*each, three_classes(), 12000, 900, "a.csv"));
    EXPECT_NO_THROW(require_fitting_signal(*each, three_classes(), 12000, 3600, "a.csv"));
    EXPECT_ERROR(require_fitting_signal(*each, three_classes(), 12000, 700, "a.csv"),
                 Exit::bad_input, "judges recordings at 0.4 to 2.5 times that speed");
  }
}

}  // namespace
}  // namespace piae::diagnosis

#include "signal/amplitude.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/errors.hpp"

namespace piae::signal {
namespace {

WindowSet two_classes() {
  WindowSet windows;
  windows.info.classes = {{"Normal", Defect::none, 0}, {"OR", Defect::outer, 0.2}};
  windows.length = 2;
  // Deviations from the windows' own means: -1 1, then -3 3.
  windows.samples = {9, 11, -3, 3};
  windows.labels = {1, 1};
  return windows;
}

TEST(Amplitude, IsTheRmsAboutTheMeanOfEachWindow) {
  const std::vector<double> rms = rms_by_class(two_classes());
  ASSERT_EQ(rms.size(), 2U);
  EXPECT_DOUBLE_EQ(rms[0], 1);  // no windows
  EXPECT_DOUBLE_EQ(rms[1], std::sqrt((1.0 + 1 + 9 + 9) / 4));
}

TEST(Amplitude, OfASignalIsTheRmsAboutItsMean) {
  const std::vector<double> signal{7, 11, 9, 9};
  EXPECT_DOUBLE_EQ(rms_of(signal), std::sqrt(8.0 / 4));
}

TEST(Amplitude, RefusesConstantWindows) {
  WindowSet windows = two_classes();
  windows.samples = {2, 2, 5, 5};
  EXPECT_ERROR(rms_by_class(windows), Exit::bad_input, "class OR");
}

}  // namespace
}  // namespace piae::signal

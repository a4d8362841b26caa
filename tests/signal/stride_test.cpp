#include "signal/stride.hpp"

#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace piae::signal {
namespace {

TEST(Stride, CountsWindows) {
  EXPECT_EQ(windows_in(1023, 1024, 1), 0U);
  EXPECT_EQ(windows_in(1024, 1024, 512), 1U);
  EXPECT_EQ(windows_in(1535, 1024, 512), 1U);
  EXPECT_EQ(windows_in(1536, 1024, 512), 2U);
  EXPECT_EQ(windows_in(121265, 1024, 512), 235U);  // the paper's stride on 105.mat
  EXPECT_EQ(windows_in(122571, 1024, 512), 238U);
}

TEST(Stride, IsTheLargestThatFits) {
  const WindowGrid grid{1024, 512, 600, 0, 0};
  EXPECT_EQ(largest_stride("x", {121265}, grid), 200U);  // (121265 - 1024) / 599 = 200.7
  EXPECT_EQ(largest_stride("x", {60984}, grid), 100U);   // (60984 - 1024) / 599 = 100.1
  EXPECT_EQ(largest_stride("x", {1024 + 599 * 512}, grid), 512U);
  EXPECT_EQ(largest_stride("x", {1024 + 599 * 512 - 1}, grid), 511U);
  EXPECT_EQ(largest_stride("x", {5000000}, grid), 512U);
  EXPECT_EQ(largest_stride("x", {1024 + 599}, grid), 1U);
}

TEST(Stride, CountsRecordsShorterThanAWindow) {
  // At stride 4: 3 + 2 + 0 windows of 4; at stride 5: 2 + 2 + 0.
  EXPECT_EQ(largest_stride("x", {12, 9, 3}, {4, 100, 5, 0, 0}), 4U);
}

TEST(Stride, SkipsEnoughWindowsForTheGuard) {
  const WindowGrid grid{1024, 512, 600, 3, 1024};
  // Starts must lie 2048 apart: 4 strides of 512, 3 windows between; 11 strides of 190, 10 between.
  EXPECT_EQ(skipped_windows(grid, 512), 3U);
  EXPECT_EQ(skipped_windows(grid, 190), 10U);
  EXPECT_EQ(skipped_windows(grid, 1), 2047U);
}

TEST(Stride, LeavesRoomForTheGaps) {
  // Length 10, guard 10: at stride 5 a gap takes 3 windows, two gaps 6, so 10 roles need 16
  // windows: 10 + 15 * 5 = 85 samples. At stride 6 (gap 3 too): 100 samples.
  const WindowGrid grid{10, 100, 10, 2, 10};
  EXPECT_EQ(largest_stride("x", {85}, grid), 5U);
  EXPECT_EQ(largest_stride("x", {99}, grid), 5U);
  EXPECT_EQ(largest_stride("x", {100}, grid), 6U);
}

TEST(Stride, ReportsHowManyWindowsFit) {
  EXPECT_ERROR(
      largest_stride("class IR", {1500, 1100}, {1024, 512, 600, 0, 0}), Exit::bad_input,
      "class IR: 600 windows of 1024 samples do not fit into 2600 samples in 2 record(s) at "
      "any stride up to 512; at most 554 fit, at stride 1");
  EXPECT_ERROR(largest_stride("class IR", {1000}, {1024, 512, 600, 0, 0}), Exit::bad_input,
               "none fits: lower window or (protocol blocked) guard-windows, in [split]");
}

TEST(Stride, IsNotLongerThanTheRecords) {
  EXPECT_EQ(largest_stride("x", {20}, {10, std::size_t{1} << 60U, 1, 0, 0}), 20U);
}

}  // namespace
}  // namespace piae::signal

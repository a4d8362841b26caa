#include "cli/progress.hpp"

#include <gtest/gtest.h>

namespace piae::cli {
namespace {

TEST(Progress, EstimatesTheRestFromTheMeanSpeed) {
  EXPECT_EQ(seconds_left(0, 20, 100, 5), 20);
  // A run that continues at 40 has taken 5 s from there.
  EXPECT_EQ(seconds_left(40, 60, 100, 5), 10);
  EXPECT_EQ(seconds_left(0, 100, 100, 5), 0);
  EXPECT_EQ(seconds_left(40, 40, 100, 5), 0);  // the rate is unknown yet
}

}  // namespace
}  // namespace piae::cli

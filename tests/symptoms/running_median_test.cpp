#include "symptoms/running_median.hpp"

#include <gtest/gtest.h>

namespace piae::symptoms {
namespace {

// Over three numbers of 5 | 5 1 4 2 3 | 3, and over five of 1 5 | 5 1 4 2 3 | 3 2.
TEST(RunningMedian, GoesOnAsAMirrorBeyondTheEnds) {
  Eigen::ArrayXd values(5);
  values << 5, 1, 4, 2, 3;
  Eigen::ArrayXd of_three(5);
  of_three << 5, 4, 2, 3, 3;
  Eigen::ArrayXd of_five(5);
  of_five << 4, 4, 3, 3, 3;
  EXPECT_TRUE((running_median(values, 3) == of_three).all());
  EXPECT_TRUE((running_median(values, 5) == of_five).all());
}

}  // namespace
}  // namespace piae::symptoms

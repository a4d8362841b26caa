#include "signal/speed_course.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace piae::signal {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

TEST(SpeedCourse, HasTheMeanOfAnyTime) {
  const SpeedCourse course{.block_s = 0.5, .rpm = {100, 200, 400}};
  EXPECT_DOUBLE_EQ(course.mean_rpm(0, 0.5), 100);
  EXPECT_DOUBLE_EQ(course.mean_rpm(0.25, 0.75), 150);
  EXPECT_DOUBLE_EQ(course.mean_rpm(0.4, 1.1), (0.1 * 100 + 0.5 * 200 + 0.1 * 400) / 0.7);
  EXPECT_DOUBLE_EQ(course.mean_rpm(0.6, 0.7), 200);
  EXPECT_DOUBLE_EQ(course.mean_rpm(1.4, 1.6), 400);
  EXPECT_DOUBLE_EQ(course.mean_rpm(2, 3), 400);
}

/// 10 turns a second at first, and 5 turns a second more with each second.
TEST(SpeedCourse, IsTheDifferenceOfAngles) {
  ShaftAngle angle;
  for (int i = 0; i <= 100; ++i) {
    const double time_s = 0.01 * i;
    angle.time_s.push_back(time_s);
    angle.turns.push_back(10 * time_s + 2.5 * time_s * time_s);
  }
  const SpeedCourse course = speed_course(angle, 1, 0);
  EXPECT_EQ(course.block_s, 0.02);
  ASSERT_EQ(course.rpm.size(), 50U);
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_NEAR(course.rpm[i], 60 * (10 + 5 * (0.02 * static_cast<double>(i) + 0.01)), 1e-9);
  }
  EXPECT_NEAR(course.mean_rpm(0, 1), 60 * 12.5, 1e-9);
  EXPECT_NEAR(course.mean_rpm(0.2, 0.4), 60 * 11.5, 1e-9);
}

TEST(SpeedCourse, GoesOnBeyondTheAngles) {
  const ShaftAngle angle{.time_s = {0.5, 1, 1.5}, .turns = {0, 1, 3}};
  EXPECT_THAT(speed_course(angle, 2.1, 1).rpm,
              ElementsAre(DoubleNear(120, 1e-9), DoubleNear(240, 1e-9), DoubleNear(240, 1e-9)));
}

}  // namespace
}  // namespace piae::signal

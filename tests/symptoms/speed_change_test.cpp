#include "symptoms/speed_change.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace piae::symptoms {
namespace {

TEST(SpeedChange, IsNothingAtTheSameSpeed) {
  EXPECT_TRUE((change_db(Eigen::Array4d(3, -1, 8, 0), {.first = 100, .step = 50}, 1) == 0).all());
}

// Bands at 100, 200, 300 and 400 Hz. At half the speed, the shaft's part of the level at 100 Hz was
// at 200 Hz, that at 200 Hz at 400 Hz, and those above stay at the last level. An octave adds 2 dB.
TEST(SpeedChange, MovesLevelsWithTheShaft) {
  const Eigen::ArrayXd change =
      change_db(Eigen::Array4d(10, 4, 6, 0), {.first = 100, .step = 100}, 0.5);
  EXPECT_NEAR(change[0], std::hypot(6, 2), 1e-12);
  EXPECT_NEAR(change[1], std::hypot(4, 2), 1e-12);
  EXPECT_NEAR(change[2], std::hypot(6, 2), 1e-12);
  EXPECT_NEAR(change[3], 2, 1e-12);
}

// At twice the speed, the levels at 100, 150 and 200 Hz move to 200, 300 and 400 Hz.
TEST(SpeedChange, InterpolatesBetweenBands) {
  const Eigen::ArrayXd change =
      change_db(Eigen::Array4d(10, 4, 6, 0), {.first = 100, .step = 100}, 2);
  EXPECT_NEAR(change[0], 2, 1e-12);
  EXPECT_NEAR(change[1], std::hypot(6, 2), 1e-12);
  EXPECT_NEAR(change[2], std::hypot(1, 2), 1e-12);
  EXPECT_NEAR(change[3], std::hypot(4, 2), 1e-12);
}

// 48 bands between 1/60 and 59/60; bands of 1200 Hz every 600 Hz from 300 Hz on.
TEST(SpeedChange, KnowsThePlacesOfTheBands) {
  EXPECT_NEAR(places_of_shape().first, 1.0 / 60 + 58.0 / 60 / 96, 1e-12);
  EXPECT_NEAR(places_of_shape().first + 47 * places_of_shape().step, 59.0 / 60 - 58.0 / 60 / 96,
              1e-12);
  EXPECT_EQ(places_of_levels().first, 900);
  EXPECT_EQ(places_of_levels().step, 600);
}

}  // namespace
}  // namespace piae::symptoms

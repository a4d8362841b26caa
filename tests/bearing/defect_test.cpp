#include "bearing/defect.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace piae::bearing {
namespace {

using std::numbers::pi;

constexpr double mil = 0.0254;  // mm

TEST(Defect, HasThePapersDepthForItsThreeSizes) {
  EXPECT_NEAR(defect_depth_m({}, 7 * mil), 0.995e-6, 0.0005e-6);
  EXPECT_NEAR(defect_depth_m({}, 14 * mil), 3.98e-6, 0.005e-6);
  EXPECT_NEAR(defect_depth_m({}, 21 * mil), 8.97e-6, 0.005e-6);
  EXPECT_EQ(defect_depth_m({}, 0), 0);
}

TEST(Defect, HasItsLengthAsChordOfTheAngle) {
  // A chord of length L under the angle 2 beta on a circle of diameter D: L = D sin(beta).
  EXPECT_NEAR(46.94 * std::sin(half_angle_rad({}, {Defect::outer, 0.5334})), 0.5334, 1e-12);
  EXPECT_NEAR(31.06 * std::sin(half_angle_rad({}, {Defect::inner, 0.5334})), 0.5334, 1e-12);
  EXPECT_NEAR(7.94 * std::sin(half_angle_rad({}, {Defect::roller, 0.5334})), 0.5334, 1e-12);
  EXPECT_EQ(half_angle_rad({}, {}), 0);
}

TEST(Defect, MeetsAnglesAcrossZero) {
  EXPECT_TRUE(meet(0.01, 2 * pi - 0.01, 0.03));
  EXPECT_TRUE(meet(2 * pi - 0.01, 0.01, 0.03));
  EXPECT_FALSE(meet(0.02, -0.02, 0.03));
  EXPECT_TRUE(meet(1 + 2 * pi * 1000, 1.01 - 2 * pi * 500, 0.011));
  EXPECT_FALSE(meet(1, 1 + pi, 3.1));
}

TEST(Defect, WrappedAnglesLieWithinHalfATurn) {
  EXPECT_NEAR(wrapped(7), 7 - 2 * pi, 1e-14);
  EXPECT_NEAR(wrapped(-7), 2 * pi - 7, 1e-14);
  EXPECT_NEAR(wrapped(3), 3, 1e-14);
}

TEST(Defect, OnABallFacesARaceTwicePerTurn) {
  for (const double centre : {pi / 2, 3 * pi / 2, -pi / 2, 2 * pi * 300 + pi / 2}) {
    EXPECT_TRUE(faces_a_race(centre + 0.019, 0.02));
    EXPECT_TRUE(faces_a_race(centre - 0.019, 0.02));
    EXPECT_FALSE(faces_a_race(centre + 0.021, 0.02));
    EXPECT_FALSE(faces_a_race(centre - 0.021, 0.02));
  }
  EXPECT_FALSE(faces_a_race(0, 0.02));
  EXPECT_FALSE(faces_a_race(pi, 0.02));
}

TEST(Defect, RefusesImpossibleSizes) {
  EXPECT_NO_THROW(validate({}, {Defect::none, 0}));
  EXPECT_NO_THROW(validate({}, {Defect::roller, 7.9}));
  EXPECT_THROW(validate({}, {Defect::none, 0.1}), Error);
  for (const Defect fault_type : {Defect::outer, Defect::inner, Defect::roller}) {
    EXPECT_NO_THROW(validate({}, {fault_type, 1}));
    EXPECT_THROW(validate({}, {fault_type, 0}), Error);
    EXPECT_THROW(validate({}, {fault_type, -1}), Error);
    EXPECT_THROW(validate({}, {fault_type, 7.94}), Error);
    EXPECT_THROW(validate({}, {fault_type, std::nan("")}), Error);
  }
}

TEST(Defect, OnARaceHoldsOneBallAtATime) {
  Geometry crowded;
  crowded.balls = 15;  // 2 balls of the inner race are 6.46 mm apart along a chord
  EXPECT_NO_THROW(validate(crowded, {Defect::inner, 6.4}));
  try {
    validate(crowded, {Defect::inner, 6.5});
    FAIL() << "two balls in one defect";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::bad_input);
    EXPECT_THAT(error.what(), testing::HasSubstr("below 6.46 mm"));
  }
}

}  // namespace
}  // namespace piae::bearing

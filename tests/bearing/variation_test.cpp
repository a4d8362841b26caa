#include "bearing/variation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace piae::bearing {
namespace {

constexpr int draws = 4000;

struct Moments {
  double mean, deviation, lowest, highest;
};

Moments moments(const std::vector<double>& x) {
  const auto n = static_cast<double>(x.size());
  double sum = 0;
  double squares = 0;
  for (const double value : x) sum += value;
  for (const double value : x) squares += (value - sum / n) * (value - sum / n);
  return {sum / n, std::sqrt(squares / n), std::ranges::min(x), std::ranges::max(x)};
}

TEST(Variation, StiffnessAndDampingAreTruncatedNormal) {
  const Variation variation{.stiffness_spread = 0.1, .damping_spread = 0.3};
  const DynamicsOptions mean;
  Stream stream("test");
  std::vector<double> k;
  std::vector<double> c;
  for (int i = 0; i < draws; ++i) {
    const DynamicsOptions drawn = draw_dynamics(stream, mean, variation);
    k.push_back(drawn.stiffness_n_per_m / mean.stiffness_n_per_m);
    c.push_back(drawn.damping_ns_per_m / mean.damping_ns_per_m);
    EXPECT_EQ(drawn.load_n, mean.load_n);
  }
  // A normal distribution cut at 3 deviations keeps 0.9866 of its deviation.
  EXPECT_NEAR(moments(k).mean, 1, 0.008);  // 5 standard errors
  EXPECT_NEAR(moments(k).deviation, 0.0987, 0.0055);
  EXPECT_GE(moments(k).lowest, 0.7);
  EXPECT_LE(moments(k).highest, 1.3);
  EXPECT_NEAR(moments(c).mean, 1, 0.024);
  EXPECT_NEAR(moments(c).deviation, 0.296, 0.0165);
  EXPECT_GE(moments(c).lowest, 0.1);
}

TEST(Variation, AnglesAndSlipFillTheirRanges) {
  Stream stream("test");
  std::vector<double> cage;
  std::vector<double> defect;
  std::vector<double> slip;
  for (int i = 0; i < draws; ++i) {
    const Motion motion = draw_motion(stream, Defect::inner, 1797, {.slip_max = 0.02});
    cage.push_back(motion.cage_angle_rad);
    defect.push_back(motion.defect_angle_rad);
    slip.push_back(motion.slip);
  }
  const double turn = 2 * std::numbers::pi;
  for (const auto& angles : {cage, defect}) {
    EXPECT_NEAR(moments(angles).mean, turn / 2, 5 * turn / std::sqrt(12.0 * draws));
    EXPECT_LT(moments(angles).lowest, 0.01 * turn);
    EXPECT_GT(moments(angles).highest, 0.99 * turn);
  }
  EXPECT_NEAR(moments(slip).mean, 0.01, 0.0005);
  EXPECT_LT(moments(slip).highest, 0.02);
}

TEST(Variation, AnOuterDefectStaysInTheLoadZone) {
  Stream stream("test");
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(draw_motion(stream, Defect::outer, 1797, {}).defect_angle_rad, 0);
    EXPECT_NE(draw_motion(stream, Defect::roller, 1797, {}).defect_angle_rad, 0);
  }
}

TEST(Variation, WithoutSpreadDrawsTheMeans) {
  const Variation none{0, 0, 0, 0};
  Stream stream("test");
  EXPECT_EQ(draw_dynamics(stream, {}, none).stiffness_n_per_m, DynamicsOptions{}.stiffness_n_per_m);
  const Motion motion = draw_motion(stream, Defect::outer, 1797, none);
  EXPECT_EQ(motion.shaft_speed_rpm, 1797);
  EXPECT_EQ(motion.slip, 0);
}

/// 1e8 N/m plus three times 10 % of it, times 2 um.
TEST(Variation, LargestLiftBelongsToTheStiffestDraw) {
  EXPECT_NEAR(largest_lift_n({}, {.stiffness_spread = 0.1}), 260, 1e-9);
}

}  // namespace
}  // namespace piae::bearing

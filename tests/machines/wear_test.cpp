#include "machines/wear.hpp"

#include <gtest/gtest.h>

#include "machines/plain_machine.hpp"

namespace piae::machines {
namespace {

/// Returns windows of weak white noise, `count` of each fault type.
signal::WindowSet weak_noise(int count) {
  signal::WindowSet set;
  set.info = plain_machine().info;
  set.length = 4096;
  Stream stream("weak");
  for (const Label label : {1, 2, 3}) {
    for (int i = 0; i < count; ++i) {
      for (std::size_t t = 0; t < set.length; ++t) {
        set.samples.push_back(static_cast<float>(stream.normal(0, 1)));
      }
      set.labels.push_back(label);
    }
  }
  return set;
}

constexpr Wear all_worn{.on_ball = 1,
                        .on_race = 1,
                        .ball_depth = 0,
                        .race_depth = 1,
                        .least_level_db = 20,
                        .largest_level_db = 20};

TEST(Wear, HasTheStatedLevelOverTheWindow) {
  signal::WindowSet set = weak_noise(5);
  std::vector<double> before;
  for (std::size_t i = 0; i < set.size(); ++i) before.push_back(power_of(set, i));
  add_wear(plain_machine(), all_worn, {}, Stream("wear"), set);
  for (std::size_t i = 0; i < set.size(); ++i) {
    EXPECT_NEAR(power_of(set, i) / before[i], 101, 6) << i;
  }
}

TEST(Wear, LeavesWindowsAloneWithProbabilityZero) {
  signal::WindowSet set = weak_noise(3);
  const std::vector<float> before = set.samples;
  add_wear(plain_machine(), {.on_ball = 0, .on_race = 0}, {}, Stream("wear"), set);
  EXPECT_EQ(set.samples, before);
}

// Its squares have a line at the impact rate of a race, here within slip and resolution, but not at
// that of a ball without modulation.
TEST(Wear, IsModulatedAtTheImpactRateOfARace) {
  signal::WindowSet set = weak_noise(12);
  add_wear(plain_machine(), all_worn, {}, Stream("wear"), set);
  const double rates_hz[] = {0, 4.5 * (1 + 7.94 / 39) * 30, 39 / 7.94 * (1 - 0.2036 * 0.2036) * 30,
                             4.5 * (1 - 7.94 / 39) * 30};
  const auto line_of = [&](Label label) {
    double sum = 0;
    for (const std::size_t i : set.indices_of(label)) {
      double highest = 0;
      for (double slip = -0.012; slip <= 0.012; slip += 0.004) {
        highest = std::max(highest, sine_in(set, i, rates_hz[label] * (1 + slip), true));
      }
      sum += highest / power_of(set, i);
    }
    return sum / 12;
  };
  EXPECT_GT(line_of(1), 0.5);
  EXPECT_GT(line_of(3), 0.5);
  EXPECT_LT(line_of(2), 0.35);
}

}  // namespace
}  // namespace piae::machines

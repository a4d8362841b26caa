#include "zero/background.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "zero/healthy.hpp"

namespace piae::zero {
namespace {

TEST(Background, IsTheHealthyWindowOrThatBackwards) {
  const signal::WindowSet healthy = healthy_windows(64, 1);
  const auto window = healthy.window(0);
  const double deviation = deviation_of(window);
  double mean = 0;
  for (const float x : window) mean += x / 64;
  int backwards = 0;
  for (int i = 0; i < 200; ++i) {
    Stream random("turn " + std::to_string(i));
    const Eigen::ArrayXd made = draw_background(window, 0, random);
    const bool turned = std::abs(made[0] - (window[0] - mean) / deviation) > 1e-5;
    backwards += turned ? 1 : 0;
    for (std::size_t t = 0; t < 64; ++t) {
      const std::size_t from = turned ? 63 - t : t;
      ASSERT_NEAR(made[static_cast<Eigen::Index>(t)], (window[from] - mean) / deviation, 1e-5);
    }
  }
  EXPECT_NEAR(backwards, 100, 30);  // four standard deviations of 7
}

TEST(Background, HasTheMeanSquareOneAlsoThroughAPath) {
  const signal::WindowSet healthy = healthy_windows();
  Stream random("path");
  const Eigen::ArrayXd made = draw_background(healthy.window(3), 6, random);
  EXPECT_NEAR(made.square().mean(), 1, 1e-9);
  Stream again("path");
  EXPECT_GT((made - draw_background(healthy.window(3), 0, again)).square().mean(), 0.01);
}

TEST(Background, LendsAWindowItsLoudness) {
  const signal::WindowSet healthy = healthy_windows();
  const Eigen::ArrayXd ramp = Eigen::ArrayXd::LinSpaced(1024, 3, 700);
  const std::vector<float> made = as_loud_as(healthy.window(4), ramp);
  EXPECT_NEAR(deviation_of(made), deviation_of(healthy.window(4)), 1e-4);
  for (const float x : as_loud_as(healthy.window(4), Eigen::ArrayXd::Zero(1024))) EXPECT_EQ(x, 0);
}

}  // namespace
}  // namespace piae::zero

#include "diffusion/path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace piae::diffusion {
namespace {

// Nichol and Dhariwal 2021, eq. 17: alpha bar(u) = f(u) / f(0), f(u) = cos^2((u + s) / (1 + s) pi /
// 2).
TEST(DiffusionPath, HasTheCosineSchedule) {
  const auto f = [](double u) {
    return std::pow(std::cos((u + 0.008) / 1.008 * std::numbers::pi / 2), 2);
  };
  for (const double u : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const Point point = point_at(Path::diffusion, u);
    EXPECT_NEAR(point.data * point.data, f(u) / f(0), 1e-12) << u;
    EXPECT_NEAR(point.data * point.data + point.noise * point.noise, 1, 1e-12) << u;
  }
}

TEST(Paths, LeadFromTheWindowToNoise) {
  for (const Path path : {Path::diffusion, Path::flow}) {
    EXPECT_NEAR(point_at(path, 0).data, 1, 1e-12);
    EXPECT_NEAR(point_at(path, 0).noise, 0, 1e-12);
    EXPECT_NEAR(point_at(path, 1).data, 0, 1e-12);
    EXPECT_NEAR(point_at(path, 1).noise, 1, 1e-12);
  }
}

// With the velocity of one pair of window and noise, a step of any length stays on their path.
TEST(Paths, AreFollowedExactlyByTheirVelocity) {
  const double window = 0.7;
  const double noise = -1.9;
  for (const Path path : {Path::diffusion, Path::flow}) {
    const Point from = point_at(path, 0.8);
    const Point to = point_at(path, 0.3);
    const Move move = move_between(path, 0.8, 0.3);
    const double x = from.data * window + from.noise * noise;
    const double v = from.velocity_of_data * window + from.velocity_of_noise * noise;
    EXPECT_NEAR(move.of_x * x + move.of_velocity * v, to.data * window + to.noise * noise, 1e-12);
  }
}

// Song, Meng and Ermon 2021, eq. 12 with sigma = 0, for a noise estimate e and alpha = alpha bar.
TEST(DiffusionPath, StepsLikeDdim) {
  const double x = 0.4;
  const double e = 1.3;
  const Point from = point_at(Path::diffusion, 0.6);
  const Point to = point_at(Path::diffusion, 0.5);
  const double alpha = from.data * from.data;
  const double next = to.data * to.data;
  const double expected =
      std::sqrt(next) * (x - std::sqrt(1 - alpha) * e) / std::sqrt(alpha) + std::sqrt(1 - next) * e;
  const double window = (x - from.noise * e) / from.data;
  const double v = from.velocity_of_data * window + from.velocity_of_noise * e;
  const Move move = move_between(Path::diffusion, 0.6, 0.5);
  EXPECT_NEAR(move.of_x * x + move.of_velocity * v, expected, 1e-12);
}

}  // namespace
}  // namespace piae::diffusion

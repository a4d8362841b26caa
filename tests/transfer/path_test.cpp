#include "transfer/path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace piae::transfer {
namespace {

constexpr Eigen::Index path_bins = 1025;
constexpr double path_rate_hz = 12000;

TEST(Path, ThatIsNotRandomChangesNothing) {
  Stream random("path");
  const Path path = draw_path(random, path_bins, path_rate_hz, 2, {});
  EXPECT_EQ(path.log_gain.abs().maxCoeff(), 0);
  EXPECT_EQ(path.phase.abs().maxCoeff(), 0);
}

TEST(Path, TiltsTheSpectrumUpAtAHigherSpeedAndDownAtALowerOne) {
  CarryOptions options;
  options.tilt = 1.5;
  double sum = 0;
  for (int i = 0; i < 400; ++i) {
    Stream random("tilt " + std::to_string(i));
    const Path path = draw_path(random, path_bins, path_rate_hz, 2, options);
    // From 1 to 4 kHz, path_bins 171 and 683: by a power from 0 to 1.5.
    const double power = (path.log_gain[683] - path.log_gain[171]) / std::log(683.0 / 171);
    EXPECT_GE(power, 0);
    EXPECT_LE(power, 1.5 + 1e-9);
    sum += power;
    Stream same("tilt " + std::to_string(i));
    const Path back = draw_path(same, path_bins, path_rate_hz, 0.5, options);
    EXPECT_NEAR((path.log_gain + back.log_gain).abs().maxCoeff(), 0, 1e-12);
  }
  EXPECT_NEAR(sum / 400, 0.75, 4 * 1.5 / std::sqrt(12 * 400.0));
}

TEST(Path, DelaysEachFrequencyByAsMuchAsItsKnotsSay) {
  CarryOptions options;
  options.dispersion_ms = 0.5;
  double squares = 0;
  for (int i = 0; i < 400; ++i) {
    Stream random("delay " + std::to_string(i));
    const Path path = draw_path(random, path_bins, path_rate_hz, 1, options);
    EXPECT_EQ(path.log_gain.abs().maxCoeff(), 0);
    // The group delay at 0 Hz, which is that of the first knot.
    const double bin = 2 * std::numbers::pi * path_rate_hz / 2 / (path_bins - 1);
    squares += std::pow(-(path.phase[1] - path.phase[0]) / bin, 2);
  }
  EXPECT_NEAR(std::sqrt(squares / 400), 0.5e-3, 4 * 0.5e-3 / std::sqrt(800.0));
}

}  // namespace
}  // namespace piae::transfer

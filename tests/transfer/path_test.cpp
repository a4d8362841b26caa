#include "transfer/path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "impacts/response.hpp"

namespace piae::transfer {
namespace {

constexpr Eigen::Index path_bins = 1025;
constexpr double path_rate_hz = 12000;

TEST(Path, WithoutRandomnessChangesNothing) {
  Stream random("path");
  const Path path = draw_path(random, path_bins, path_rate_hz, 2, false, {});
  EXPECT_EQ(path.log_gain.abs().maxCoeff(), 0);
  EXPECT_EQ(path.phase.abs().maxCoeff(), 0);
}

TEST(Path, TiltsTheSpectrumUpAtAHigherSpeedAndDownAtALowerOne) {
  CarryOptions options;
  options.tilt = 1.5;
  double sum = 0;
  for (int i = 0; i < 400; ++i) {
    Stream random("tilt " + std::to_string(i));
    const Path path = draw_path(random, path_bins, path_rate_hz, 2, false, options);
    // From 1 to 4 kHz (bins 171 and 683), by a power from 0 to 1.5.
    const double power = (path.log_gain[683] - path.log_gain[171]) / std::log(683.0 / 171);
    EXPECT_GE(power, 0);
    EXPECT_LE(power, 1.5 + 1e-9);
    sum += power;
    Stream same("tilt " + std::to_string(i));
    const Path back = draw_path(same, path_bins, path_rate_hz, 0.5, false, options);
    EXPECT_NEAR((path.log_gain + back.log_gain).abs().maxCoeff(), 0, 1e-12);
  }
  EXPECT_NEAR(sum / 400, 0.75, 4 * 1.5 / std::sqrt(12 * 400.0));
}

TEST(Path, DelaysEachFrequencyByItsKnots) {
  CarryOptions options;
  options.dispersion_ms = 0.5;
  double squares = 0;
  for (int i = 0; i < 400; ++i) {
    Stream random("delay " + std::to_string(i));
    const Path path = draw_path(random, path_bins, path_rate_hz, 1, false, options);
    EXPECT_EQ(path.log_gain.abs().maxCoeff(), 0);
    // The group delay at 0 Hz, which is that of the first knot.
    const double bin = 2 * std::numbers::pi * path_rate_hz / 2 / (path_bins - 1);
    squares += std::pow(-(path.phase[1] - path.phase[0]) / bin, 2);
  }
  EXPECT_NEAR(std::sqrt(squares / 400), 0.5e-3, 4 * 0.5e-3 / std::sqrt(800.0));
}

TEST(Path, HasItsOwnDeviationForAnotherBearing) {
  CarryOptions options;
  options.equaliser = {.spread_db = 1, .knots = 8};
  options.other_bearing_db = 10;
  const auto spread_db = [&](bool to_other) {
    double sum = 0;
    for (int i = 0; i < 400; ++i) {
      Stream random("bearing " + std::to_string(i));
      const Path path = draw_path(random, path_bins, path_rate_hz, 1, to_other, options);
      sum += std::pow(20 * std::log10(std::exp(path.log_gain[0])), 2);  // a knot
    }
    return std::sqrt(sum / 400);
  };
  // A standard deviation from 400 samples is accurate to 1 / sqrt(800); the test allows three times
  // that.
  EXPECT_NEAR(spread_db(false), 1, 0.11);
  EXPECT_NEAR(spread_db(true), 10, 1.1);
}

TEST(Path, DelayMovesTheImpulse) {
  const Eigen::ArrayXd flat = Eigen::ArrayXd::Zero(path_bins);
  // A delay of 10 samples: each is a phase of pi at half the sampling rate.
  const Path late{.log_gain = flat,
                  .phase = -10 * Eigen::ArrayXd::LinSpaced(path_bins, 0, std::numbers::pi)};
  Eigen::Index place = 0;
  impacts::samples_of(response_behind(late, flat)).abs().maxCoeff(&place);
  EXPECT_EQ(place, 10);
}

}  // namespace
}  // namespace piae::transfer

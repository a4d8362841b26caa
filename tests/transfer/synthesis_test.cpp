#include "transfer/synthesis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "spectra/power.hpp"

namespace piae::transfer {
namespace {

using Eigen::ArrayXd;

constexpr Eigen::Index frame_bins = 1025;  // of a frame of 2048 samples
constexpr double frame_rate_hz = 12000;

Path no_path() {
  return {.log_gain = ArrayXd::Zero(frame_bins), .phase = ArrayXd::Zero(frame_bins)};
}

TEST(Synthesis, AStructureThatDoesNotRingShowsTheBlowsThemselves) {
  // Blows 300 samples into the window and 24 later, the other way; one before the window is gone.
  const std::vector<Strike> strikes{{.time_s = 500 / frame_rate_hz},
                                    {.time_s = (1024 + 300) / frame_rate_hz,
                                     .strength = 2,
                                     .lag_s = 24 / frame_rate_hz,
                                     .exit = 0.5}};
  const ArrayXd window =
      struck_window(ArrayXd::Zero(frame_bins), no_path(), strikes, frame_rate_hz);
  ASSERT_EQ(window.size(), 1024);
  EXPECT_NEAR(window.square().mean(), 1, 1e-12);
  EXPECT_NEAR(window[324] / window[300], -0.5, 1e-9);
  EXPECT_NEAR(window.square().sum() - window[300] * window[300] - window[324] * window[324], 0,
              1e-9);
}

TEST(Synthesis, ADelayMovesTheWindow) {
  Path late = no_path();
  // 10 samples: pi at half the sampling rate for each.
  late.phase = -10 * ArrayXd::LinSpaced(frame_bins, 0, 3.14159265358979324);
  const std::vector<Strike> strikes{{.time_s = 1324 / frame_rate_hz}};
  const ArrayXd window = struck_window(ArrayXd::Zero(frame_bins), late, strikes, frame_rate_hz);
  Eigen::Index place = 0;
  window.abs().maxCoeff(&place);
  EXPECT_EQ(place, 310);
}

TEST(Synthesis, TheBackgroundHasTheColourOfTheStructureAndTheEdges) {
  const Edges edges{.lag_s = 1e-3, .exit = 0.8, .spread = 0};
  ArrayXd answer(frame_bins);
  for (Eigen::Index i = 0; i < frame_bins; ++i) answer[i] = i < 512 ? 0 : std::log(0.1);
  spectra::Windows windows(400, 1024);
  for (Eigen::Index i = 0; i < windows.rows(); ++i) {
    Stream random("background " + std::to_string(i));
    const ArrayXd window = background_window(answer, edges, frame_rate_hz, random);
    EXPECT_NEAR(window.square().mean(), 1, 1e-12);
    windows.row(i) = window.transpose().matrix();
  }
  // A bin of 400 windows is right to 5 %: minima of the edges lie at whole multiples of 1 kHz.
  const ArrayXd power = spectra::mean_power_spectrum(windows);
  const auto at = [&](double hz) { return power[std::lround(hz / frame_rate_hz * 1024)]; };
  EXPECT_NEAR(std::sqrt(at(1500) / at(2500)), 1, 0.2);
  EXPECT_NEAR(std::sqrt(at(2000) / at(2500)), 0.2 / 1.8, 0.05);
  EXPECT_NEAR(std::sqrt(at(4500) / at(2500)), 0.1, 0.02);
}

}  // namespace
}  // namespace piae::transfer

#include "impacts/synthesis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "spectra/power.hpp"

namespace piae::impacts {
namespace {

using Eigen::ArrayXd;

constexpr Eigen::Index frame_bins = 1025;  // bins of a frame of 2048 samples
constexpr double frame_rate_hz = 12000;

ArrayXd impact_window(const std::vector<Impact>& impacts) {
  return window_of(impact_frame(impacts, Eigen::ArrayXcd::Ones(frame_bins), frame_rate_hz),
                   frame_bins - 1);
}

TEST(Synthesis, StructureWithoutRingingShowsTheImpacts) {
  // Impulses of opposite sign, 300 samples into the window and 24 later. The impulse before the
  // window is not in it.
  const ArrayXd window = impact_window({{.time_s = 500 / frame_rate_hz},
                                        {.time_s = (1024 + 300) / frame_rate_hz,
                                         .strength = 2,
                                         .lag_s = 24 / frame_rate_hz,
                                         .exit = 0.5}});
  ASSERT_EQ(window.size(), 1024);
  EXPECT_NEAR(window.square().mean(), 1, 1e-12);
  EXPECT_NEAR(window[324] / window[300], -0.5, 1e-9);
  EXPECT_NEAR(window.square().sum() - window[300] * window[300] - window[324] * window[324], 0,
              1e-9);
  EXPECT_TRUE(impact_window({}).isZero(0));
}

TEST(Synthesis, BackgroundHasTheColourOfStructureAndEdges) {
  const Edges edges{.lag_s = 1e-3, .exit = 0.8, .spread = 0};
  ArrayXd response(frame_bins);
  for (Eigen::Index i = 0; i < frame_bins; ++i) response[i] = i < 512 ? 0 : std::log(0.1);
  spectra::Windows windows(400, 1024);
  for (Eigen::Index i = 0; i < windows.rows(); ++i) {
    Stream random("background " + std::to_string(i));
    const ArrayXd window = noise_window(response, edges, frame_rate_hz, random);
    EXPECT_NEAR(window.square().mean(), 1, 1e-12);
    windows.row(i) = window.transpose().matrix();
  }
  // A bin over 400 windows is accurate to 5 %: minima of the edges lie at whole multiples of 1 kHz.
  const ArrayXd power = spectra::mean_power_spectrum(windows);
  const auto at = [&](double hz) { return power[std::lround(hz / frame_rate_hz * 1024)]; };
  EXPECT_NEAR(std::sqrt(at(1500) / at(2500)), 1, 0.2);
  EXPECT_NEAR(std::sqrt(at(2000) / at(2500)), 0.2 / 1.8, 0.05);
  EXPECT_NEAR(std::sqrt(at(4500) / at(2500)), 0.1, 0.02);
}

TEST(Synthesis, ExcitationIsTheSumOfItsImpulses) {
  const Impact first{.time_s = 0.0101, .strength = 1.5, .lag_s = 0.0013, .exit = 0.6};
  const Impact second{.time_s = 0.0237, .strength = 0.5, .lag_s = 0.0011, .exit = 0.6};
  const Eigen::ArrayXcd found = excitation({first, second}, 1025, 5.86);
  for (Eigen::Index i = 0; i < 1025; i += 64) {
    const double hz = 5.86 * static_cast<double>(i);
    std::complex<double> expected = 0;
    for (const Impact& impact : {first, second}) {
      expected += impact.strength * std::polar(1.0, -2 * std::numbers::pi * hz * impact.time_s) *
                  Edges{.lag_s = impact.lag_s, .exit = impact.exit, .spread = 0}.gain(hz);
    }
    EXPECT_NEAR(std::abs(found[i] - expected), 0, 1e-9) << hz;
  }
}

}  // namespace
}  // namespace piae::impacts

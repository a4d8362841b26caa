#include "zero/impulses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "zero/healthy.hpp"

namespace piae::zero {
namespace {

TEST(Impulses, ComeAtTheKinematicRateOnly) {
  const signal::WindowSet healthy = healthy_windows(4096);
  const Machine machine(healthy);
  const signal::MadeWindow made =
      add_impulses(machine, {}, scene_of(healthy, bearing::Defect::outer), Stream("window"));
  const double period_s = 1 / (30 * 4.5 * (1 - 7.94 / 39));
  ASSERT_NEAR(static_cast<double>(made.impact_times_s->size()), 4096 / 12000.0 / period_s, 1);
  for (std::size_t i = 1; i < made.impact_times_s->size(); ++i) {
    EXPECT_NEAR(made.impact_times_s->at(i) - made.impact_times_s->at(i - 1), period_s, 1e-9);
  }
  EXPECT_FALSE(made.parameters);
}

/// Returns the fraction of a window's energy in a range of frequencies.
double share_at(const std::vector<float>& window, double from_hz, double to_hz) {
  double share = 0;
  double all = 0;
  for (std::size_t bin = 1; bin < window.size() / 2; ++bin) {
    std::complex<double> sum = 0;
    for (std::size_t t = 0; t < window.size(); ++t) {
      sum += static_cast<double>(window[t]) *
             std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(bin * t % window.size()) /
                                 static_cast<double>(window.size()));
    }
    const double hz = 12000.0 * static_cast<double>(bin) / static_cast<double>(window.size());
    all += std::norm(sum);
    if (hz >= from_hz && hz <= to_hz) share += std::norm(sum);
  }
  return share / all;
}

TEST(Impulses, ExciteOneDampedResonanceAtTheDrawnLevel) {
  const signal::WindowSet healthy = healthy_windows();
  const Machine machine(healthy);
  // A third of half the sampling rate is 2 kHz. At 20 dB the healthy window has 1 % of the power.
  const ImpulseOptions high_level{.lowest_part = 1.0 / 3,
                                  .highest_part = 1.0 / 3,
                                  .least_damping = 0.02,
                                  .largest_damping = 0.02,
                                  .least_level_db = 20,
                                  .largest_level_db = 20};
  const Scene scene = scene_of(healthy, bearing::Defect::inner);
  const signal::MadeWindow made = add_impulses(machine, high_level, scene, Stream("window"));
  // Half of the power is within the half-power width of 2 zeta f = 80 Hz; 0.94 is within 10 such
  // widths.
  EXPECT_GT(share_at(made.samples, 1600, 2400), 0.88);
  EXPECT_NEAR(deviation_of(made.samples) / deviation_of(scene.healthy), 1, 1e-5);
}

TEST(Impulses, AreFiniteInWindowsOfAboutOnePeriod) {
  signal::WindowSet healthy = healthy_windows(16);
  healthy.info.shaft_speed_rpm = 13000;  // BPFO is 776 Hz
  const Machine machine(healthy);
  const signal::WindowSet made =
      make_windows(machine, 200, Stream("many"), [&](const Scene& scene, const Stream& random) {
        return add_impulses(machine, {}, scene, random);
      });
  EXPECT_TRUE(std::ranges::all_of(made.samples, [](float x) { return std::isfinite(x); }));
  EXPECT_TRUE(made.parameters.empty());
}

}  // namespace
}  // namespace piae::zero

#include "zero/twin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/errors.hpp"
#include "zero/background.hpp"
#include "zero/healthy.hpp"

namespace piae::zero {
namespace {

using bearing::Defect;

/// Returns a prior with equal impacts only: no slip, no path, and only the healthy window as
/// background.
Prior plain() {
  Prior prior;
  prior.slip = 0;
  prior.jitter = 0;
  prior.ball_jitter = 0;
  prior.load_zone = Switch::off;
  prior.load.rotating = 0;
  prior.load.scatter = 0;
  prior.other_race = 1;
  prior.new_phase = 0;
  prior.random_impacts = 0;
  prior.least_on_track = 1;
  prior.roughness = 0;
  prior.background_db = 0;
  prior.modulation = 0;
  prior.stray_impacts = 0;
  return prior;
}

TEST(ZeroTwin, BallWithoutTurnsHasPeriodicImpacts) {
  const signal::WindowSet healthy = healthy_windows(4096);
  const Machine machine(healthy);
  const Scene scene = scene_of(healthy, Defect::roller);
  const signal::MadeWindow made = Twin(machine, plain()).make(scene, Stream("window"));
  // 2 BSF of a 6205 at 30 turns a second.
  const double period_s = 1 / (30 * 39 / 7.94 * (1 - std::pow(7.94 / 39, 2)));
  ASSERT_NEAR(static_cast<double>(made.impact_times_s->size()), 4096 / 12000.0 / period_s, 1);
  for (std::size_t i = 1; i < made.impact_times_s->size(); ++i) {
    EXPECT_NEAR(made.impact_times_s->at(i) - made.impact_times_s->at(i - 1), period_s, 1e-9);
  }
}

TEST(ZeroTwin, SlipsWithItsCage) {
  const signal::WindowSet healthy = healthy_windows(65536, 1);
  const Machine machine(healthy);
  const Scene scene = scene_of(healthy, Defect::roller);
  // A ball has impacts only in the load zone, for 0.37 of a turn of the cage.
  Prior prior = plain();
  prior.slip = 0.2;
  prior.load_zone = Switch::on;
  prior.load.least_extent = 0.3;
  prior.load.largest_extent = 0.3;
  double fastest_s = 1;
  double slowest_s = 0;
  for (int i = 0; i < 8; ++i) {
    const std::vector<double> impact_times =
        *Twin(machine, prior).make(scene, Stream("slip " + std::to_string(i))).impact_times_s;
    const double period_s =
        impact_times.at(2) - impact_times.at(1) < impact_times.at(1) - impact_times.at(0)
            ? impact_times[2] - impact_times[1]
            : impact_times[1] - impact_times[0];
    std::vector<double> passes;
    for (std::size_t k = 1; k < impact_times.size(); ++k) {
      if (impact_times[k] - impact_times[k - 1] > 1.5 * period_s) passes.push_back(impact_times[k]);
    }
    ASSERT_GT(passes.size(), 50U);
    const double cage_s = (passes.back() - passes.front()) / static_cast<double>(passes.size() - 1);
    // For every slip, 2 BSF is 2 (D / d + 1) times FTF. Over 50 turns, the first and the last are
    // located to one impact.
    EXPECT_NEAR(cage_s / period_s, 2 * (39 / 7.94 + 1), 2.0 / 50) << i;
    fastest_s = std::min(fastest_s, period_s);
    slowest_s = std::max(slowest_s, period_s);
  }
  EXPECT_GT(slowest_s / fastest_s, 1.2);
}

/// Returns the level of everything that a window adds to the healthy window, played forwards or
/// backwards, relative to the healthy window.
double level_to_healthy_db(const signal::MadeWindow& made, const Scene& scene) {
  Eigen::ArrayXd healthy =
      Eigen::Map<const Eigen::ArrayXf>(scene.healthy.data(), std::ssize(scene.healthy))
          .cast<double>();
  healthy -= healthy.mean();
  const Eigen::ArrayXd window =
      Eigen::Map<const Eigen::ArrayXf>(made.samples.data(), std::ssize(made.samples))
          .cast<double>();
  const double forwards = std::abs((window * healthy).mean());
  const double backwards = std::abs((window * healthy.reverse()).mean());
  const double healthy_power =
      std::pow(std::max(forwards, backwards), 2) / healthy.square().mean();  // power ratio
  return 10 * std::log10((window.square().mean() - healthy_power) / healthy_power);
}

TEST(ZeroTwin, HasStrayImpactsAtTheirLevelOverTheBackground) {
  const signal::WindowSet healthy = healthy_windows(4096);
  const Machine machine(healthy);
  const Scene scene = scene_of(healthy, Defect::outer);
  Prior prior = plain();  // leaves only the stray impacts
  prior.stray_impacts = 1;
  prior.least_level_db = -300;
  prior.largest_level_db = -300;
  double lowest_db = 0;
  double highest_db = 0;
  double sum_db = 0;
  for (int i = 0; i < 300; ++i) {
    const double db = level_to_healthy_db(
        Twin(machine, prior).make(scene, Stream("knocks " + std::to_string(i))), scene);
    lowest_db = std::min(lowest_db, db);
    highest_db = std::max(highest_db, db);
    sum_db += db;
  }
  // Uniform from -15 to 5 dB. Stray impacts and background are slightly correlated in 4096 samples.
  EXPECT_NEAR(lowest_db, -15, 0.7);
  EXPECT_NEAR(highest_db, 5, 0.7);
  EXPECT_NEAR(sum_db / 300, -5, 4 * 20 / std::sqrt(12.0 * 300));
}

TEST(ZeroTwin, HasTheDrawnLevelOverTheBackground) {
  const signal::WindowSet healthy = healthy_windows(4096);
  const Machine machine(healthy);
  const Scene scene = scene_of(healthy, Defect::outer);
  for (const double db : {-10.0, 0.0, 10.0}) {
    Prior prior = plain();
    prior.least_level_db = db;
    prior.largest_level_db = db;
    const Stream random("window");
    const signal::MadeWindow made = Twin(machine, prior).make(scene, random);
    Stream under = random.child("background");
    const Eigen::ArrayXd background = draw_background(scene.healthy, 0, under);
    Eigen::ArrayXd window(4096);
    for (Eigen::Index t = 0; t < 4096; ++t) window[t] = made.samples[static_cast<std::size_t>(t)];
    // window = g (10^(db/20) y + b), with y and b of mean square 1. They are independent, so b
    // explains 1 / (1 + 10^(db/10)) of the window's power.
    const double explained = std::pow((window * background).mean(), 2) / window.square().mean();
    EXPECT_NEAR(explained, 1 / (1 + std::pow(10, db / 10)), 0.05) << db;
  }
}

TEST(ZeroTwin, HasTheRmsOfTheHealthyWindow) {
  const signal::WindowSet healthy = healthy_windows();
  const Machine machine(healthy);
  const Scene scene = scene_of(healthy, Defect::inner);
  const signal::MadeWindow made = Twin(machine, {}).make(scene, Stream("window"));
  EXPECT_NEAR(deviation_of(made.samples) / deviation_of(scene.healthy), 1, 1e-5);
}

TEST(ZeroTwin, RingsAsItsStrongestResonance) {
  const signal::WindowSet healthy = healthy_windows();
  const Machine machine(healthy);
  Prior prior;
  prior.mass_kg = 2;
  for (int i = 0; i < 100; ++i) {
    const signal::MadeWindow made =
        Twin(machine, prior).make(scene_of(healthy, Defect::outer), Stream(std::to_string(i)));
    ASSERT_TRUE(made.parameters);
    const double natural_hz =
        std::sqrt(made.parameters->stiffness_n_per_m / 2) / 2 / std::numbers::pi;
    EXPECT_GE(natural_hz, 600 - 1e-6);
    EXPECT_LE(natural_hz, 5700 + 1e-6);
    const double ratio =
        made.parameters->damping_ns_per_m / 2 / std::sqrt(made.parameters->stiffness_n_per_m * 2);
    EXPECT_GE(ratio, 0.01 - 1e-9);
    EXPECT_LE(ratio, 0.08 + 1e-9);
  }
}

TEST(ZeroTwin, MakesFiniteWindowsOfAnyLengthAndDefect) {
  for (const std::size_t length : {16U, 63U, 64U, 1024U}) {
    signal::WindowSet healthy = healthy_windows(length);
    healthy.info.shaft_speed_rpm = 13000;  // BPFO is 776 Hz: one impact in 15.5 samples
    const Machine machine(healthy);
    const Twin twin(machine, {});
    const signal::WindowSet made = make_windows(
        machine, 100, Stream("many"),
        [&](const Scene& scene, const Stream& random) { return twin.make(scene, random); });
    ASSERT_EQ(made.samples.size(), 300 * length);
    EXPECT_TRUE(std::ranges::all_of(made.samples, [](float x) { return std::isfinite(x); }));
    for (const std::vector<double>& impact_times : made.impact_times_s) {
      EXPECT_TRUE(std::ranges::is_sorted(impact_times));
      for (const double time_s : impact_times) {
        EXPECT_GE(time_s, 0);
        EXPECT_LT(time_s, static_cast<double>(length) / 12000);
      }
    }
  }
}

TEST(ZeroTwin, KeepsTheRestIfOnePartIsRemoved) {
  const signal::WindowSet healthy = healthy_windows(4096);
  const Machine machine(healthy);
  const Scene scene = scene_of(healthy, Defect::inner);
  Prior without;
  without.stray_impacts = 0;
  without.modulation = 0;
  without.roughness = 0;
  const signal::MadeWindow all = Twin(machine, {}).make(scene, Stream("window"));
  const signal::MadeWindow fewer = Twin(machine, without).make(scene, Stream("window"));
  EXPECT_EQ(all.impact_times_s, fewer.impact_times_s);
  EXPECT_EQ(all.parameters->stiffness_n_per_m, fewer.parameters->stiffness_n_per_m);
  EXPECT_NE(all.samples, fewer.samples);
}

TEST(ZeroTwin, RefusesDefectsTooLargeForTheBearing) {
  signal::WindowSet healthy = healthy_windows();
  healthy.info.bearing.inner_raceway_mm = 5;
  const Machine machine(healthy);
  EXPECT_ERROR(Twin(machine, {}), Exit::bad_input, "distance between two balls");
}

TEST(ZeroWindows, HaveConditionAndSpeedIfConditionsDiffer) {
  signal::WindowSet healthy = healthy_windows(256);
  healthy.info.conditions = {{.name = "slow", .shaft_speed_rpm = 900},
                             {.name = "fast", .shaft_speed_rpm = 1800}};
  healthy.condition = {0, 0, 0, 1, 1, 1};
  healthy.shaft_speed_rpm = {900, 900, 900, 1800, 1800, 1800};
  const Machine machine(healthy);
  const Twin twin(machine, {});
  const signal::WindowSet made = make_windows(
      machine, 3, Stream("conditions"),
      [&](const Scene& scene, const Stream& random) { return twin.make(scene, random); });
  EXPECT_EQ(made.condition, (std::vector<std::int32_t>{0, 1, 0, 0, 1, 0, 0, 1, 0}));
  EXPECT_EQ(made.shaft_speed_rpm,
            (std::vector<double>{900, 1800, 900, 900, 1800, 900, 900, 1800, 900}));
  EXPECT_EQ(made.parameters.size(), 9U);
}

}  // namespace
}  // namespace piae::zero

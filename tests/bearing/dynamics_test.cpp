#include "bearing/dynamics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/error.hpp"

namespace piae::bearing {
namespace {

constexpr double rate_hz = 12000;
constexpr Motion running{.shaft_speed_rpm = 1797, .cage_angle_rad = 0.3};

double rms(const std::vector<double>& x) {
  double sum = 0;
  for (const double value : x) sum += value * value;
  return std::sqrt(sum / static_cast<double>(x.size()));
}

double relative_error(const std::vector<double>& x, const std::vector<double>& truth) {
  std::vector<double> difference;
  for (std::size_t i = 0; i < x.size(); ++i) difference.push_back(x[i] - truth[i]);
  return rms(difference) / rms(truth);
}

// --- Eq. 13 without contact: a damped oscillator, released 1 um beside its equilibrium. ---

constexpr EquationOfMotion oscillator{.mass_kg = 1.3,
                                      .damping_ns_per_m = 700,
                                      .stiffness_n_per_m = 2e8,
                                      .contact_n_per_m15 = 0,
                                      .load_n = 1500};
constexpr double released_m = 1e-6;

/// s' of s = W / K + released e^(-z t) (cos(w t) + z / w sin(w t)), with z = C / 2M, w^2 = K/M -
/// z^2.
double oscillator_velocity(double time_s) {
  const double z = oscillator.damping_ns_per_m / (2 * oscillator.mass_kg);
  const double k = oscillator.stiffness_n_per_m / oscillator.mass_kg;
  const double w = std::sqrt(k - z * z);
  return -released_m * k / w * std::exp(-z * time_s) * std::sin(w * time_s);
}

std::vector<double> closed_form(std::size_t samples) {
  std::vector<double> acceleration;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / rate_hz;
    acceleration.push_back((oscillator_velocity(t + 1 / rate_hz) - oscillator_velocity(t)) *
                           rate_hz);
  }
  return acceleration;
}

double oscillator_error(double max_sub_step_s) {
  const BallPassage passage({}, {}, running, 0);
  State state{oscillator.load_n / oscillator.stiffness_n_per_m + released_m, 0};
  const auto acceleration =
      integrate(oscillator, passage, state, 0, {rate_hz, 200}, max_sub_step_s);
  return relative_error(acceleration, closed_form(200));
}

TEST(Integrate, DampedOscillatorIsTheClosedForm) { EXPECT_LT(oscillator_error(2e-6), 1e-7); }

TEST(Integrate, IsOfFourthOrderWhereNothingJumps) {
  const double interval_s = 1 / rate_hz;
  const double ratio = oscillator_error(interval_s / 4) / oscillator_error(interval_s / 8);
  EXPECT_NEAR(ratio, 16, 2);
}

TEST(Integrate, LeavesTheLastStateBehind) {
  const BallPassage passage({}, {}, running, 0);
  const State start{oscillator.load_n / oscillator.stiffness_n_per_m + released_m, 0};
  State whole = start;
  const auto all = integrate(oscillator, passage, whole, 0, {rate_hz, 20}, 2e-6);
  State halves = start;
  integrate(oscillator, passage, halves, 0, {rate_hz, 10}, 2e-6);
  EXPECT_NEAR(halves[1], oscillator_velocity(10 / rate_hz), 1e-9);
  const auto second = integrate(oscillator, passage, halves, 10 / rate_hz, {rate_hz, 10}, 2e-6);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(second[i], all[10 + i], 1e-9);
}

// --- The equation itself ---

TEST(EquationOfMotion, SumsTheForcesOfTheBalls) {
  const EquationOfMotion e{2, 300, 1e8, 1e10, 1000};
  // Compressions of 4 um (along 1), 1 um (along 1/2: 4 um less 2 um clearance, less 1 um) and none.
  const std::vector<BallContact> balls{{1, 4e-6}, {0.5, 3e-6}, {0.25, 2e-6}};
  const double contact = 1e10 * (8e-9 + 0.5 * 1e-9);  // 4e-6^1.5 = 8e-9, 1e-6^1.5 = 1e-9
  EXPECT_NEAR(e.acceleration({8e-6, 0.1}, balls), (1000 - 30 - 800 - contact) / 2, 1e-9);
}

TEST(StaticEquilibrium, BalancesLoadSpringAndBalls) {
  // One ball below the load: 1e8 * 6 um + 1e10 * (4 um)^1.5 = 600 N + 80 N.
  EXPECT_NEAR(static_equilibrium_m({1, 500, 1e8, 1e10, 680}, {{{1, 2e-6}}}), 6e-6, 1e-18);
  EXPECT_NEAR(static_equilibrium_m({1, 500, 1e8, 0, 680}, {}), 6.8e-6, 1e-18);
}

// --- Whole bearings ---

TEST(Simulate, HealthyBearingStaysNearEquilibrium) {
  const auto acceleration = simulate({}, {}, running, {}, {rate_hz, 12000});
  // Less than a hundred thousandth of the load over the mass, but not silent: balls pass.
  EXPECT_LT(rms(acceleration), 0.05);
  EXPECT_GT(rms(acceleration), 0.001);
}

TEST(Simulate, LargerDefectsAreLouder) {
  for (const Defect kind : {Defect::outer, Defect::inner, Defect::roller}) {
    const double healthy = rms(simulate({}, {}, running, {}, {rate_hz, 6000}));
    const double small = rms(simulate({}, {kind, 0.1778}, running, {}, {rate_hz, 6000}));
    const double large = rms(simulate({}, {kind, 0.5334}, running, {}, {rate_hz, 6000}));
    EXPECT_GT(small, 100 * healthy);
    EXPECT_GT(large, 3 * small);
  }
}

TEST(Simulate, SubStepsOfTwoMicrosecondsAreFineEnough) {
  const auto error = [](double max_sub_step_s) {
    const LocalDefect defect{Defect::outer, 0.1778};
    const Sampling sampling{rate_hz, 3000};
    DynamicsOptions fine;
    fine.max_sub_step_s = 0.05e-6;
    DynamicsOptions coarse;
    coarse.max_sub_step_s = max_sub_step_s;
    return relative_error(simulate({}, defect, running, coarse, sampling),
                          simulate({}, defect, running, fine, sampling));
  };
  const double default_error = error(DynamicsOptions{}.max_sub_step_s);
  EXPECT_LT(default_error, 0.02);
  EXPECT_LT(error(0.25e-6), default_error / 3);  // first order: 8 where the jumps fall alike
  EXPECT_GT(error(16e-6), default_error * 3);
}

TEST(Simulate, AnglesHoldAtTheFirstSample) {
  const LocalDefect defect{Defect::inner, 0.5334};
  const std::size_t later = 1000;
  const auto whole = simulate({}, defect, running, {}, {rate_hz, 3000});
  const Speeds s = speeds({}, running.shaft_speed_rpm);
  Motion advanced = running;
  advanced.cage_angle_rad += s.cage * later / rate_hz;
  advanced.defect_angle_rad += s.shaft * later / rate_hz;
  const auto part = simulate({}, defect, advanced, {}, {rate_hz, 2000});
  const std::vector<double> rest(whole.begin() + later, whole.end());
  EXPECT_LT(relative_error(part, rest), 0.01);  // what is left of the start after settling
}

TEST(Simulate, AllBallsAreAlikeUnlessOneIsFaulty) {
  Motion next = running;
  next.cage_angle_rad += 2 * std::numbers::pi / 9;
  const auto error = [&next](const LocalDefect& defect) {
    return relative_error(simulate({}, defect, next, {}, {rate_hz, 1200}),
                          simulate({}, defect, running, {}, {rate_hz, 1200}));
  };
  EXPECT_LT(error({Defect::outer, 0.1778}), 1e-6);
  EXPECT_GT(error({Defect::roller, 0.1778}), 0.1);
}

TEST(Simulate, GivesTheSameTwice) {
  const LocalDefect defect{Defect::roller, 0.1778};
  EXPECT_EQ(simulate({}, defect, running, {}, {rate_hz, 1200}),
            simulate({}, defect, running, {}, {rate_hz, 1200}));
}

std::string message(const DynamicsOptions& options, Exit exit = Exit::bad_input,
                    const Sampling& sampling = {rate_hz, 100}) {
  try {
    simulate({}, {Defect::outer, 0.1778}, running, options, sampling);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), exit);
    return error.what();
  }
  return "no error";
}

TEST(Simulate, LoadMustCloseTheClearance) {
  EXPECT_THAT(message({.load_n = 200}), testing::HasSubstr("does not close the clearance"));
  EXPECT_THAT(message({.load_n = 199}), testing::HasSubstr("200 N, and the load must exceed it"));
  EXPECT_EQ(message({.load_n = 201}), "no error");
}

TEST(Simulate, ContactIsThereUpToTheLargestStiffness) {
  DynamicsOptions options{.clearance_um = 4, .load_n = 600};
  options.stiffness_n_per_m = largest_stiffness_n_per_m(options);
  EXPECT_EQ(message(options), "no error");
  options.stiffness_n_per_m *= 1.05;
  EXPECT_THAT(message(options), testing::HasSubstr("does not close the clearance"));
}

TEST(Simulate, RefusesImpossibleValues) {
  using testing::HasSubstr;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, infinite}) {
    EXPECT_THAT(message({.mass_kg = bad}), HasSubstr("mass"));
    EXPECT_THAT(message({.stiffness_n_per_m = bad}), HasSubstr("stiffness"));
    EXPECT_THAT(message({.load_n = bad}), HasSubstr("load"));
    EXPECT_THAT(message({.max_sub_step_s = bad}), HasSubstr("sub-step"));
    EXPECT_THAT(message({}, Exit::bad_input, {bad, 100}), HasSubstr("sample rate"));
  }
  for (const double bad : {-1.0, nan, infinite}) {
    EXPECT_THAT(message({.damping_ns_per_m = bad}), HasSubstr("damping"));
    EXPECT_THAT(message({.clearance_um = bad}), HasSubstr("clearance"));
    EXPECT_THAT(message({.settling_s = bad}), HasSubstr("settling"));
  }
}

TEST(Simulate, DivergenceIsAnError) {
  // C / M = 1e7 per second: explicit steps of 2 us cannot follow.
  EXPECT_THAT(message({.damping_ns_per_m = 1e7}, Exit::failed), testing::HasSubstr("diverged at"));
}

}  // namespace
}  // namespace piae::bearing

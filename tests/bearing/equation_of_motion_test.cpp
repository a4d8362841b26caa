#include "bearing/equation_of_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "bearing/dynamics.hpp"

namespace piae::bearing {
namespace {

constexpr double sampled_hz = 12000;

/// Returns the same number for every course.
PerCourse all(double x) { return PerCourse{} + x; }

EquationOfMotion equation(double mass_kg, double damping_ns_per_m, double stiffness_n_per_m,
                          double contact_n_per_m15, double load_n) {
  return {all(mass_kg), all(damping_ns_per_m), all(stiffness_n_per_m), all(contact_n_per_m15),
          all(load_n)};
}

// --- Eq. 13 without contact: a damped oscillator, released 1 um away from its equilibrium. ---

constexpr double mass_kg = 1.3;
constexpr double damping_ns_per_m = 700;
constexpr double stiffness_n_per_m = 2e8;
constexpr double load_n = 1500;
constexpr double released_m = 1e-6;

/// Returns s' of s = W / K + released e^(-z t) (cos(w t) + z / w sin(w t)), with z = C / 2M, w^2 =
/// K/M - z^2.
double oscillator_velocity(double time_s) {
  const double z = damping_ns_per_m / (2 * mass_kg);
  const double k = stiffness_n_per_m / mass_kg;
  const double w = std::sqrt(k - z * z);
  return -released_m * k / w * std::exp(-z * time_s) * std::sin(w * time_s);
}

double closed_form(std::size_t sample) {
  const double t = static_cast<double>(sample) / sampled_hz;
  return (oscillator_velocity(t + 1 / sampled_hz) - oscillator_velocity(t)) * sampled_hz;
}

LoadedBalls any_balls() {
  const Motion running{.shaft_speed_rpm = 1797, .cage_angle_rad = 0.3};
  const double clearance_m = 0;
  return {{}, {}, std::span(&running, 1), std::span(&clearance_m, 1)};
}

State released() { return {all(load_n / stiffness_n_per_m + released_m), all(0)}; }

Solution oscillation(State& state, double start_s, std::size_t samples, double max_sub_step_s) {
  LoadedBalls balls = any_balls();
  return solve(equation(mass_kg, damping_ns_per_m, stiffness_n_per_m, 0, load_n), balls, state,
               start_s, {sampled_hz, samples}, sub_steps(sampled_hz, max_sub_step_s));
}

/// Returns the relative error over 200 samples.
double oscillator_error(double max_sub_step_s) {
  State state = released();
  const Solution solution = oscillation(state, 0, 200, max_sub_step_s);
  double difference = 0;
  double truth = 0;
  for (std::size_t i = 0; i < 200; ++i) {
    difference += std::pow(solution.acceleration[i][0] - closed_form(i), 2);
    truth += std::pow(closed_form(i), 2);
  }
  return std::sqrt(difference / truth);
}

TEST(Solve, MatchesTheClosedFormOfADampedOscillator) { EXPECT_LT(oscillator_error(2e-6), 1e-7); }

TEST(Solve, IsOfFourthOrderForSmoothForces) {
  const double interval_s = 1 / sampled_hz;
  const double ratio = oscillator_error(interval_s / 4) / oscillator_error(interval_s / 8);
  EXPECT_NEAR(ratio, 16, 2);
}

TEST(Solve, ReturnsTheLastState) {
  State whole = released();
  const Solution all_samples = oscillation(whole, 0, 20, 2e-6);
  State halves = released();
  oscillation(halves, 0, 10, 2e-6);
  EXPECT_NEAR(halves.velocity[0], oscillator_velocity(10 / sampled_hz), 1e-9);
  const Solution second = oscillation(halves, 10 / sampled_hz, 10, 2e-6);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_NEAR(second.acceleration[i][0], all_samples.acceleration[10 + i][0], 1e-9);
  }
}

TEST(Solve, CountsTheFiniteSamplesOfEachCourse) {
  LoadedBalls balls = any_balls();
  EquationOfMotion e = equation(mass_kg, damping_ns_per_m, stiffness_n_per_m, 0, load_n);
  e.damping_ns_per_m[0] = 1e7;  // over the mass 8e6 per second: steps of 2 us are too long
  State state = released();
  const Solution solution =
      solve(e, balls, state, 0, {sampled_hz, 200}, sub_steps(sampled_hz, 2e-6));
  EXPECT_LT(solution.sane_samples[0], 5);
  for (std::size_t i = 1; i < courses_at_once; ++i) EXPECT_EQ(solution.sane_samples[i], 200);
}

// --- The equation itself ---

TEST(EquationOfMotion, SumsTheForcesOfTheBalls) {
  // Compressions: 4 um (along 1), 1 um (along 1/2: 4 um minus 2 um clearance minus 1 um) and none.
  const std::vector<BallContact> balls{
      {all(1), all(4e-6)}, {all(0.5), all(3e-6)}, {all(0.25), all(2e-6)}};
  const double contact = 1e10 * (8e-9 + 0.5 * 1e-9);  // 4e-6^1.5 = 8e-9, 1e-6^1.5 = 1e-9
  const PerCourse force = equation(2, 300, 1e8, 1e10, 1000).force_n({all(8e-6), all(0.1)}, balls);
  for (std::size_t i = 0; i < courses_at_once; ++i) {
    EXPECT_NEAR(force[i], 1000 - 30 - 800 - contact, 1e-9);
  }
}

TEST(StaticEquilibrium, BalancesLoadSpringAndBalls) {
  // One ball below the load: 1e8 * 6 um + 1e10 * (4 um)^1.5 = 600 N + 80 N.
  const std::vector<BallContact> ball{{all(1), all(2e-6)}};
  EXPECT_NEAR(static_equilibrium_m(equation(1, 500, 1e8, 1e10, 680), ball)[0], 6e-6, 1e-18);
  EXPECT_NEAR(static_equilibrium_m(equation(1, 500, 1e8, 0, 680), {})[0], 6.8e-6, 1e-18);
}

TEST(StaticEquilibrium, IsFoundFromFarAbove) {
  // The balls carry all: 1e10 * (1 um)^1.5 = 10 N. Without them the spring gives way by 10 m.
  const std::vector<BallContact> ball{{all(1), all(0)}};
  EXPECT_NEAR(static_equilibrium_m(equation(1, 500, 1, 1e10, 10), ball)[0], 1e-6, 1e-12);
}

}  // namespace
}  // namespace piae::bearing

#include "bearing/dynamics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <span>
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

TEST(SubSteps, AreTheFewestForTheLongestStep) {
  EXPECT_EQ(sub_steps(12000, 2e-6).count, 42U);  // 83.3 us
  EXPECT_DOUBLE_EQ(sub_steps(12000, 2e-6).step_s, 1 / 12000.0 / 42);
  EXPECT_EQ(sub_steps(12000, 1).count, 1U);
}

TEST(Simulate, HealthyBearingStaysNearEquilibrium) {
  const auto acceleration = simulate({}, {}, running, {}, {rate_hz, 12000});
  // Less than a hundred thousandth of the load over the mass, but not 0, because balls pass.
  EXPECT_LT(rms(acceleration), 0.05);
  EXPECT_GT(rms(acceleration), 0.001);
}

TEST(Simulate, LargerDefectsHaveALargerRms) {
  for (const Defect fault_type : {Defect::outer, Defect::inner, Defect::roller}) {
    const double healthy = rms(simulate({}, {}, running, {}, {rate_hz, 6000}));
    const double small = rms(simulate({}, {fault_type, 0.1778}, running, {}, {rate_hz, 6000}));
    const double large = rms(simulate({}, {fault_type, 0.5334}, running, {}, {rate_hz, 6000}));
    EXPECT_GT(small, 100 * healthy);
    EXPECT_GT(large, 3 * small);
  }
}

TEST(Simulate, SubStepsOfTwoMicrosecondsSuffice) {
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
  EXPECT_LT(error(0.25e-6), default_error / 3);  // first order: 8 if the jumps fall alike
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
  EXPECT_LT(relative_error(part, rest), 0.01);  // rest of the initial transient
}

TEST(Simulate, AnAppearingDefectActsFromTheFirstImpact) {
  const LocalDefect defect{Defect::outer, 0.5334};
  Motion before_impact = running;  // a ball has just left the defect; the next comes after 8 ms
  before_impact.cage_angle_rad = 0.1;
  const Course course{before_impact, {}};
  const Sampling sampling{rate_hz, 2400};
  const auto healthy = simulate({}, {}, before_impact, {}, sampling);
  const auto always = simulate({}, defect, before_impact, {}, sampling);
  const auto onset = simulate_onset({}, defect, std::span(&course, 1), sampling);
  const auto from = [](const std::vector<double>& x, std::size_t first, std::size_t count) {
    const auto begin = x.begin() + static_cast<std::ptrdiff_t>(first);
    return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  EXPECT_LT(relative_error(from(onset, 0, 80), from(healthy, 0, 80)), 1e-6);
  EXPECT_GT(relative_error(from(always, 0, 80), from(healthy, 0, 80)), 1);  // still rings
  EXPECT_GT(rms(from(onset, 80, 100)), 100 * rms(from(healthy, 80, 100)));
  EXPECT_LT(relative_error(from(onset, 1200, 1200), from(always, 1200, 1200)), 1e-6);
}

TEST(Simulate, BallsAreEqualUnlessOneIsFaulty) {
  Motion next = running;
  next.cage_angle_rad += 2 * std::numbers::pi / 9;
  const auto error = [&next](const LocalDefect& defect) {
    return relative_error(simulate({}, defect, next, {}, {rate_hz, 1200}),
                          simulate({}, defect, running, {}, {rate_hz, 1200}));
  };
  EXPECT_LT(error({Defect::outer, 0.1778}), 1e-6);
  EXPECT_GT(error({Defect::roller, 0.1778}), 0.1);
}

TEST(Simulate, IsReproducible) {
  const LocalDefect defect{Defect::roller, 0.1778};
  EXPECT_EQ(simulate({}, defect, running, {}, {rate_hz, 1200}),
            simulate({}, defect, running, {}, {rate_hz, 1200}));
}

std::string refusal(const DynamicsOptions& options, Exit exit = Exit::bad_input,
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
  EXPECT_THAT(refusal({.load_n = 200}), testing::HasSubstr("does not close the clearance"));
  EXPECT_THAT(refusal({.load_n = 199}), testing::HasSubstr("200 N, and the load must exceed it"));
  EXPECT_EQ(refusal({.load_n = 201}), "no error");
}

TEST(Simulate, ContactHoldsUpToTheLargestStiffness) {
  DynamicsOptions options{.clearance_um = 4, .load_n = 600};
  options.stiffness_n_per_m = largest_stiffness_n_per_m(options);
  EXPECT_EQ(refusal(options), "no error");
  options.stiffness_n_per_m *= 1.05;
  EXPECT_THAT(refusal(options), testing::HasSubstr("does not close the clearance"));
}

TEST(Simulate, RefusesImpossibleValues) {
  using testing::HasSubstr;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, infinite}) {
    EXPECT_THAT(refusal({.mass_kg = bad}), HasSubstr("mass"));
    EXPECT_THAT(refusal({.stiffness_n_per_m = bad}), HasSubstr("stiffness"));
    EXPECT_THAT(refusal({.load_n = bad}), HasSubstr("load"));
    EXPECT_THAT(refusal({.max_sub_step_s = bad}), HasSubstr("sub-step"));
    EXPECT_THAT(refusal({}, Exit::bad_input, {bad, 100}), HasSubstr("sample rate"));
  }
  for (const double bad : {-1.0, nan, infinite}) {
    EXPECT_THAT(refusal({.damping_ns_per_m = bad}), HasSubstr("damping"));
    EXPECT_THAT(refusal({.clearance_um = bad}), HasSubstr("clearance"));
    EXPECT_THAT(refusal({.settling_s = bad}), HasSubstr("settling"));
  }
}

TEST(Simulate, ReportsDivergence) {
  // C / M = 1e7 per second: explicit steps of 2 us cannot follow.
  EXPECT_THAT(refusal({.damping_ns_per_m = 1e7}, Exit::failed), testing::HasSubstr("diverged at"));
}

}  // namespace
}  // namespace piae::bearing

#include "bearing/dynamics.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"

namespace piae::bearing {

namespace {

void require_positive(double value, const std::string& what) {
  if (value > 0 && std::isfinite(value)) return;
  throw Error(Exit::bad_input, fmt::format("{} {}; it must be positive and finite", what, value));
}

void require_not_negative(double value, const std::string& what) {
  if (value >= 0 && std::isfinite(value)) return;
  throw Error(Exit::bad_input, fmt::format("{} {}; it must be finite, 0 or more", what, value));
}

void validate_dynamics(const DynamicsOptions& o) {
  require_positive(o.mass_kg, "mass in kg");
  require_positive(o.stiffness_n_per_m, "stiffness in N/m");
  require_not_negative(o.damping_ns_per_m, "damping in N s/m");
  require_not_negative(o.clearance_um, "clearance in um");
  require_positive(o.load_n, "load in N");
  require_not_negative(o.settling_s, "settling time in s");
  const double lift = o.stiffness_n_per_m * o.clearance_um * 1e-6;
  if (o.load_n > lift) return;
  throw Error(Exit::bad_input,
              fmt::format("load {} N does not close the clearance: stiffness times clearance is {} "
                          "N, and the load must exceed it",
                          o.load_n, lift));
}

/// Throws unless all courses have the same settling time and the same longest sub-step.
void require_same_times(std::span<const Course> courses) {
  const auto differ = [](const Course& a, const Course& b) {
    return a.options.settling_s != b.options.settling_s ||
           a.options.max_sub_step_s != b.options.max_sub_step_s;
  };
  if (std::ranges::adjacent_find(courses, differ) != courses.end()) {
    throw Error(Exit::bad_input, "courses differ in settling time or longest sub-step");
  }
}

/// Returns the equations of up to courses_at_once courses. The last course fills the lanes that are
/// left.
EquationOfMotion equation_of(const Geometry& geometry, std::span<const Course> courses) {
  EquationOfMotion equation{};
  for (std::size_t lane = 0; lane < courses_at_once; ++lane) {
    const DynamicsOptions& o = courses[std::min(lane, courses.size() - 1)].options;
    equation.mass_kg[lane] = o.mass_kg;
    equation.damping_ns_per_m[lane] = o.damping_ns_per_m;
    equation.stiffness_n_per_m[lane] = o.stiffness_n_per_m;
    equation.contact_n_per_m15[lane] = contact_stiffness(geometry, o.hertz);
    equation.load_n[lane] = o.load_n;
  }
  return equation;
}

LoadedBalls balls_of(const Geometry& geometry, const LocalDefect& defect,
                     std::span<const Course> courses) {
  std::vector<Motion> motions;
  std::vector<double> clearances_m;
  for (const Course& course : courses) {
    motions.push_back(course.motion);
    clearances_m.push_back(course.options.clearance_um * 1e-6);
  }
  return {geometry, defect, motions, clearances_m};
}

/// Writes the courses' samples after settling, row by row. Throws Error(failed) if a course
/// diverged.
void write_rows(const Solution& solution, std::size_t settling, std::size_t courses,
                const Sampling& sampling, double step_s, double* rows) {
  const std::size_t samples = solution.acceleration.size();
  for (std::size_t lane = 0; lane < courses; ++lane) {
    const auto sane = static_cast<std::size_t>(solution.sane_samples[lane]);
    if (sane < samples) {
      const double since_first_sample =
          static_cast<double>(sane + 1) - static_cast<double>(settling);
      throw Error(Exit::failed,
                  fmt::format("eq. 13 diverged at {:.6g} s with sub-steps of {:.3g} "
                              "s; stiffness and damping over mass require shorter ones",
                              since_first_sample / sampling.rate_hz, step_s));
    }
    for (std::size_t i = settling; i < samples; ++i) *rows++ = solution.acceleration[i][lane];
  }
}

/// simulate() for at most courses_at_once courses.
void simulate_at_once(const Geometry& geometry, const LocalDefect& defect,
                      std::span<const Course> courses, const Sampling& sampling, double* rows) {
  const DynamicsOptions& times = courses.front().options;
  const SubSteps steps = sub_steps(sampling.rate_hz, times.max_sub_step_s);
  LoadedBalls balls = balls_of(geometry, defect, courses);
  const EquationOfMotion equation = equation_of(geometry, courses);
  const double settling_samples = std::ceil(times.settling_s * sampling.rate_hz);
  const double start_s = -settling_samples / sampling.rate_hz;
  balls.set(start_s);
  State state{static_equilibrium_m(equation, balls.contacts()), PerCourse{}};
  const auto settling = static_cast<std::size_t>(settling_samples);
  const Solution solution = solve(equation, balls, state, start_s,
                                  {sampling.rate_hz, settling + sampling.samples}, steps);
  write_rows(solution, settling, courses.size(), sampling, steps.step_s, rows);
}

/// simulate_onset() for at most courses_at_once courses.
void simulate_onset_at_once(const Geometry& geometry, const LocalDefect& defect,
                            std::span<const Course> courses, const Sampling& sampling,
                            double* rows) {
  const DynamicsOptions& times = courses.front().options;
  const SubSteps steps = sub_steps(sampling.rate_hz, times.max_sub_step_s);
  const EquationOfMotion equation = equation_of(geometry, courses);
  LoadedBalls healthy = balls_of(geometry, {}, courses);
  const double settling_samples = std::ceil(times.settling_s * sampling.rate_hz);
  const double start_s = -settling_samples / sampling.rate_hz;
  healthy.set(start_s);
  State state{static_equilibrium_m(equation, healthy.contacts()), PerCourse{}};
  const auto settling = static_cast<std::size_t>(settling_samples);
  const Solution before =
      solve(equation, healthy, state, start_s, {sampling.rate_hz, settling}, steps);
  write_rows(before, settling, courses.size(), sampling, steps.step_s, rows);
  LoadedBalls defective = balls_of(geometry, defect, courses);
  const Solution after = solve(equation, defective, state, 0, sampling, steps);
  write_rows(after, 0, courses.size(), sampling, steps.step_s, rows);
}

/// Simulates all courses, courses_at_once at a time.
std::vector<double> simulate_by(decltype(simulate_at_once)& at_once, const Geometry& geometry,
                                const LocalDefect& defect, std::span<const Course> courses,
                                const Sampling& sampling) {
  for (const Course& course : courses) validate_dynamics(course.options);
  require_same_times(courses);
  std::vector<double> accelerations(courses.size() * sampling.samples);
  for (std::size_t i = 0; i < courses.size(); i += courses_at_once) {
    at_once(geometry, defect, courses.subspan(i, std::min(courses_at_once, courses.size() - i)),
            sampling, accelerations.data() + i * sampling.samples);
  }
  return accelerations;
}

}  // namespace

double largest_stiffness_n_per_m(const DynamicsOptions& options) {
  return 0.98 * options.load_n / (options.clearance_um * 1e-6);
}

SubSteps sub_steps(double rate_hz, double max_sub_step_s) {
  require_positive(rate_hz, "sample rate in Hz");
  require_positive(max_sub_step_s, "longest sub-step in s");
  const double interval_s = 1 / rate_hz;
  const double count = std::ceil(interval_s / max_sub_step_s);
  return {static_cast<std::size_t>(count), interval_s / count};
}

std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             std::span<const Course> courses, const Sampling& sampling) {
  return simulate_by(simulate_at_once, geometry, defect, courses, sampling);
}

std::vector<double> simulate_onset(const Geometry& geometry, const LocalDefect& defect,
                                   std::span<const Course> courses, const Sampling& sampling) {
  return simulate_by(simulate_onset_at_once, geometry, defect, courses, sampling);
}

std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             const Motion& motion, const DynamicsOptions& options,
                             const Sampling& sampling) {
  const Course course{motion, options};
  return simulate(geometry, defect, std::span(&course, 1), sampling);
}

}  // namespace piae::bearing

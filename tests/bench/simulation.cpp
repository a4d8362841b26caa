// Times eq. 13 by bearing::simulate and by the scalar reference of the tests.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "base/random.hpp"
#include "bearing/dynamics.hpp"
#include "bearing/variation.hpp"
#include "bench/machine.hpp"
#include "support/reference_dynamics.hpp"

namespace {

using namespace piae::bearing;

constexpr Sampling window{12000, 1024};
constexpr DynamicsOptions options;

/// Returns the floating point operations of one course in one sub-step, counted in loaded_balls.cpp
/// and equation_of_motion.cpp. An addition, multiplication, comparison or square root counts as
/// one, a selection as zero. The reference is credited with the same number, whatever it needs.
double flops_of_sub_step(int balls) {
  const int ahead = (balls + 1) / 2;  // balls that are followed
  const int rotation = 6;             // operations to rotate a direction
  const int turn = 5 * rotation + 2;  // three by the step, two by a ball that may enter
  const int position = 2 * (3 + 1);   // per ball: its cosine, and the cosine from the defect
  const int contact = 3 + 5;          // compression, if positive; x sqrt(x) along, sum
  const int stage = ahead * contact + 6 + 1;  // the other forces, over the mass
  const int states = 3 * 4 + 2 * 5 + 4;       // later stages, mean of the rates, last state
  return 2 * (turn + 1 + ahead * position) + 4 * stage + states;
}

double sub_steps_of_window() {
  const double samples = window.samples + std::ceil(options.settling_s * window.rate_hz);
  return samples * static_cast<double>(sub_steps(window.rate_hz, options.max_sub_step_s).count);
}

/// Counts each ball that is followed, in each of the four stages. Includes balls that touch in no
/// course, although their roots are skipped.
int roots_of_sub_step(int balls) { return 4 * ((balls + 1) / 2); }

/// Returns the square roots of doubles per second.
double peak_roots_per_s() {
  constexpr std::size_t chains = 12;  // a root has a long latency
  const auto round = [](std::array<PerCourse, chains>& x) {
    for (PerCourse& chain : x) chain = piae::positive_root(chain) + 1;
  };
  return chains * courses_at_once * piae::bench::rounds_per_s<double, chains>(round);
}

std::vector<Course> drawn_courses(Defect fault_type) {
  piae::Stream stream("bench");
  std::vector<Course> courses;
  for (std::size_t i = 0; i < courses_at_once; ++i) {
    const DynamicsOptions drawn = draw_dynamics(stream, options, {});
    courses.push_back({draw_motion(stream, fault_type, 1797, {}), drawn});
  }
  return courses;
}

LocalDefect defect_of(const benchmark::State& state) {
  const auto fault_type = static_cast<Defect>(state.range(0));
  return {fault_type, fault_type == Defect::none ? 0 : 0.1778};
}

/// Times `solve`, which solves `windows` windows, and returns windows per second. "of_flops" and
/// "of_roots" are its additions and multiplications, and its square roots, relative to a core that
/// does nothing else, measured in the same run. The larger one tells how close this is to the
/// machine's limit.
template <class Solve>
double measure(benchmark::State& state, std::size_t windows, const Solve& solve) {
  static const double peak_flops = piae::bench::peak_flops_per_s<double>();
  static const double peak_roots = peak_roots_per_s();
  const double start = piae::bench::processor_seconds();
  while (state.KeepRunning()) benchmark::DoNotOptimize(solve());
  const double taken = piae::bench::processor_seconds() - start;
  const double windows_per_s = static_cast<double>(state.iterations() * windows) / taken;
  const double sub_steps_per_s = windows_per_s * sub_steps_of_window();
  const double flops_per_s = sub_steps_per_s * flops_of_sub_step(Geometry{}.balls);
  state.counters["windows/s"] = windows_per_s;
  state.counters["flop/s"] = flops_per_s;
  state.counters["of_flops"] = flops_per_s / peak_flops;
  state.counters["of_roots"] = sub_steps_per_s * roots_of_sub_step(Geometry{}.balls) / peak_roots;
  return windows_per_s;
}

/// Windows per second of the scalar reference, which is measured first, by fault type.
std::map<std::int64_t, double> reference_rates;

void compare_with_reference(benchmark::State& state, double windows_per_s) {
  const auto reference = reference_rates.find(state.range(0));
  if (reference == reference_rates.end()) return;
  state.counters["times_reference"] = windows_per_s / reference->second;
}

/// Solves as many windows as fit at once.
void solve_side_by_side(benchmark::State& state) {
  const LocalDefect defect = defect_of(state);
  const std::vector<Course> courses = drawn_courses(defect.fault_type);
  compare_with_reference(
      state, measure(state, courses.size(), [&] { return simulate({}, defect, courses, window); }));
}

/// Solves one window, which takes the time of a full set of lanes.
void solve_alone(benchmark::State& state) {
  const LocalDefect defect = defect_of(state);
  const Course course = drawn_courses(defect.fault_type).front();
  compare_with_reference(state, measure(state, 1, [&] {
                           return simulate({}, defect, course.motion, course.options, window);
                         }));
}

void solve_by_reference(benchmark::State& state) {
  const LocalDefect defect = defect_of(state);
  const Course course = drawn_courses(defect.fault_type).front();
  reference_rates[state.range(0)] = measure(state, 1, [&] {
    return reference::simulate({}, defect, course.motion, course.options, window);
  });
}

void each_kind(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("defect")
      ->DenseRange(static_cast<int>(Defect::none), static_cast<int>(Defect::roller))
      ->Unit(benchmark::kMillisecond);
}

BENCHMARK(solve_by_reference)->Apply(each_kind);
BENCHMARK(solve_side_by_side)->Apply(each_kind);
BENCHMARK(solve_alone)->Apply(each_kind);

}  // namespace

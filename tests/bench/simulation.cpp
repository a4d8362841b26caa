#include <benchmark/benchmark.h>

#include <cmath>

#include "bearing/dynamics.hpp"

namespace {

using namespace piae::bearing;

/// One second of a bearing at 12 kHz, settling included; the argument is the kind of its defect.
void simulate_one_second(benchmark::State& state) {
  const auto kind = static_cast<Defect>(state.range(0));
  const LocalDefect defect{kind, kind == Defect::none ? 0 : 0.1778};
  const Motion motion{.shaft_speed_rpm = 1797};
  const DynamicsOptions options;
  const Sampling sampling{12000, 12000};
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(simulate({}, defect, motion, options, sampling));
  }
  const double steps_per_sample = std::ceil(1 / (sampling.rate_hz * options.max_sub_step_s));
  const double samples = sampling.samples + options.settling_s * sampling.rate_hz;
  state.counters["sub_steps/s"] =
      benchmark::Counter(steps_per_sample * samples, benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(simulate_one_second)
    ->ArgName("defect")
    ->DenseRange(static_cast<int>(Defect::none), static_cast<int>(Defect::roller))
    ->Unit(benchmark::kMillisecond);

}  // namespace

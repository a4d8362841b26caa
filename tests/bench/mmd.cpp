// MMD of 495 generated against 495 real windows of 1024 samples, as `score` computes it for a
// class.

#include "scoring/mmd.hpp"

#include <benchmark/benchmark.h>
#include <omp.h>

#include "base/random.hpp"

namespace {

using piae::scoring::Windows;

constexpr Eigen::Index count = 495;
constexpr Eigen::Index length = 1024;

Windows noise(const char* name) {
  piae::Stream stream(name);
  Windows windows(count, length);
  for (double& sample : windows.reshaped()) sample = stream.normal(0, 1);
  return windows;
}

/// Argument: threads. The three matrix products (x x', y y', x y') are what is counted.
void mmd(benchmark::State& state) {
  omp_set_num_threads(static_cast<int>(state.range(0)));
  const Windows x = noise("bench/mmd/x");
  const Windows y = noise("bench/mmd/y");
  const double squared_distance = piae::scoring::mean_squared_distance(y);
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(piae::scoring::mmd_squared(x, y, squared_distance));
  }
  state.counters["FLOP/s"] = benchmark::Counter(3.0 * 2.0 * count * count * length,
                                                benchmark::Counter::kIsIterationInvariantRate,
                                                benchmark::Counter::kIs1000);
}

BENCHMARK(mmd)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

// Times the MMD of 495 generated and 495 real windows of 1024 samples, as `score` computes it for a
// class. Compares it with a large matrix product and with the core's peak.

#include "scoring/mmd.hpp"

#include <benchmark/benchmark.h>

#include "base/random.hpp"
#include "bench/machine.hpp"

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

void count_flops(benchmark::State& state, double flops_per_s) {
  static const double peak = piae::bench::peak_flops_per_s<double>();
  state.counters["flop/s"] = flops_per_s;
  state.counters["of_peak"] = flops_per_s / peak;
}

/// Floating point operations per second of the last matrix product timed.
double product_flops_per_s = 0;

/// Times Eigen's product, with operands that suit it.
void dgemm_1024(benchmark::State& state) {
  constexpr Eigen::Index n = 1024;
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(n, n);
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(n, n);
  Eigen::MatrixXd c(n, n);
  const double start = piae::bench::processor_seconds();
  while (state.KeepRunning()) {
    c.noalias() = a * b;
    benchmark::DoNotOptimize(c.data());
  }
  product_flops_per_s = 2.0 * n * n * n * static_cast<double>(state.iterations()) /
                        (piae::bench::processor_seconds() - start);
  count_flops(state, product_flops_per_s);
}
BENCHMARK(dgemm_1024)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

/// Counts only the three matrix products (x x', y y', x y'), not the kernels' exponentials.
void mmd_of_a_class(benchmark::State& state) {
  const Windows x = noise("bench/mmd/x");
  const Windows y = noise("bench/mmd/y");
  const double squared_distance = piae::scoring::mean_squared_distance(y);
  const double start = piae::bench::processor_seconds();
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(piae::scoring::mmd_squared(x, y, squared_distance));
  }
  const double flops_per_s = 3.0 * 2.0 * count * count * length *
                             static_cast<double>(state.iterations()) /
                             (piae::bench::processor_seconds() - start);
  count_flops(state, flops_per_s);
  if (product_flops_per_s > 0) state.counters["of_product"] = flops_per_s / product_flops_per_s;
}
BENCHMARK(mmd_of_a_class)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

}  // namespace

// Times t-SNE and its parts with as many points as CWRU has test windows and the features of
// WDCNN's hidden layer. A pair is the effect of one point on another, once in each step.

#include "embedding/tsne.hpp"

#include <benchmark/benchmark.h>

#include "base/random.hpp"
#include "bench/machine.hpp"
#include "embedding/neighbours.hpp"
#include "embedding/trustworthiness.hpp"
#include "embedding/tsne_cost.hpp"

namespace {

using namespace piae::embedding;

constexpr Eigen::Index count = 1000;
constexpr Eigen::Index features = 100;
constexpr Eigen::Index classes = 10;

/// Returns ten clouds, 5 standard deviations from the middle.
Points clouds() {
  piae::Stream stream("bench/tsne");
  Points points(count, features);
  for (double& coordinate : points.reshaped<Eigen::RowMajor>()) coordinate = stream.normal(0, 1);
  for (Eigen::Index i = 0; i < count; ++i) points(i, i % classes) += 5;
  return points;
}

void tsne_1000_points(benchmark::State& state) {
  const Points points = clouds();
  while (state.KeepRunning()) benchmark::DoNotOptimize(tsne(points).kl_divergence);
}
BENCHMARK(tsne_1000_points)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

void pair_probabilities_1000_points(benchmark::State& state) {
  const Points points = clouds();
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(pair_probabilities(squared_distances(points), 30).sum());
  }
}
BENCHMARK(pair_probabilities_1000_points)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

/// Returns the most divisions per second of this core; a step consists mostly of divisions.
double peak_divisions_per_s() {
  constexpr std::size_t chains = 12;
  const auto round = [](std::array<piae::Vector<float>, chains>& x) {
    for (piae::Vector<float>& chain : x) chain = 1.0F / (chain + 1.0F);
  };
  return static_cast<double>(chains) * piae::lanes<float> *
         piae::bench::rounds_per_s<float, chains>(round);
}

void gradient_of_1000_points(benchmark::State& state) {
  const Points points = clouds();
  const KlGradient gradient_at(pair_probabilities(squared_distances(points), 30));
  const Plane map = 3 * points.leftCols(2);
  const double start = piae::bench::processor_seconds();
  while (state.KeepRunning()) benchmark::DoNotOptimize(gradient_at(map));
  const double pairs_per_s = static_cast<double>(count * count * state.iterations()) /
                             (piae::bench::processor_seconds() - start);
  state.counters["pair/s"] = pairs_per_s;
  state.counters["of_peak_divisions"] = pairs_per_s / peak_divisions_per_s();
}
BENCHMARK(gradient_of_1000_points)->MeasureProcessCPUTime()->Unit(benchmark::kMicrosecond);

void trustworthiness_of_1000_points(benchmark::State& state) {
  const Points points = clouds();
  const Points map = points.leftCols(2);
  while (state.KeepRunning()) benchmark::DoNotOptimize(trustworthiness(points, map));
}
BENCHMARK(trustworthiness_of_1000_points)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

}  // namespace

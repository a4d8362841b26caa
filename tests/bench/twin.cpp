// One training epoch of PIAE-DT as on CWRU: 45 known windows of 1024 samples, 9 fault classes,
// batch 5. Stage 1 (eq. 24) and Stage 2 (eq. 25) cost differently and are timed apart.

#include <benchmark/benchmark.h>

#include "known_windows.hpp"
#include "twin/native_backend.hpp"
#include "twin/training.hpp"

namespace piae::twin {
namespace {

void twin_training_epoch(benchmark::State& state) {
  const signal::WindowSet known = known_windows();
  const auto training =
      make_twin_training(known, TwinOptions{}, full_model, Stream("bench"), native_engine("cpu"));
  training->run_epoch(0);  // LibTorch warms up
  // With one epoch a stage, even epochs are in Stage 1 and odd ones in Stage 2.
  const auto epoch = static_cast<std::size_t>(state.range(0) - 1);
  while (state.KeepRunning()) training->run_epoch(epoch);
  state.counters["windows/s"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * static_cast<double>(known.size()),
      benchmark::Counter::kIsRate);
}
BENCHMARK(twin_training_epoch)->ArgName("stage")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace piae::twin

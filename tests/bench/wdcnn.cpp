// One training epoch of WDCNN: batch 32, 545 windows (500 healthy and nine classes of 5).

#include "diagnosis/wdcnn.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

namespace piae::diagnosis {
namespace {

LabelledWindows noise(std::size_t n) {
  Stream stream("bench/wdcnn");
  LabelledWindows set;
  set.length = 1024;
  set.classes = 10;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t t = 0; t < set.length; ++t) {
      set.samples.push_back(static_cast<float>(stream.normal(0, 1)));
    }
    set.labels.push_back(static_cast<std::int32_t>(i % set.classes));
  }
  return set;
}

// The time is that which train_and_test measures, of the epochs alone: the first, in which LibTorch
// warms up, is spread over ten.
void wdcnn_training_epoch(benchmark::State& state) {
  const LabelledWindows train = noise(545);
  const LabelledWindows test = noise(2);
  WdcnnOptions options;
  options.epochs = 10;
  options.batch = 32;
  double epochs = 0;
  for (auto _ : state) {
    const WdcnnResult result = train_and_test(train, test, options, Stream("bench"), "cpu");
    state.SetIterationTime(result.training_seconds / static_cast<double>(options.epochs));
    epochs += 1;
  }
  state.counters["windows/s"] =
      benchmark::Counter(epochs * static_cast<double>(train.size()), benchmark::Counter::kIsRate);
}
BENCHMARK(wdcnn_training_epoch)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace piae::diagnosis

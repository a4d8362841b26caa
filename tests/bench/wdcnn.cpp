// WDCNN's training, batch 32, 545 windows (500 healthy and nine classes of 5): the native back end
// against LibTorch's, and its arithmetic against that of a large matrix product. Rates are by the
// processor's time, so that other programs on the machine count little.

#include "diagnosis/wdcnn.hpp"

#include <benchmark/benchmark.h>

#include "diagnosis/libtorch_backend.hpp"
#include "diagnosis/native_backend.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "machine.hpp"
#include "nets/torch.hpp"

namespace piae::diagnosis {
namespace {

constexpr std::size_t windows = 545;
constexpr std::size_t length = 1024;
constexpr std::size_t classes = 10;

LabelledWindows noise(std::size_t n) {
  Stream stream("bench/wdcnn");
  LabelledWindows set;
  set.length = length;
  set.classes = classes;
  for (std::size_t i = 0; i < n * length; ++i) {
    set.samples.push_back(static_cast<float>(stream.normal(0, 1)));
  }
  for (std::size_t i = 0; i < n; ++i) set.labels.push_back(static_cast<std::int32_t>(i % classes));
  return set;
}

/// Additions and multiplications that training on a window needs: a product of matrices forward,
/// one for the weight's gradient, and one for the input's but in the first layer. All else, such as
/// batch normalisation and Adam, is left out.
double operations_per_window() {
  double sum = 0;
  std::int64_t at = length;
  for (std::size_t i = 0; i < WdcnnLayers::convolutions.size(); ++i) {
    const Convolution& c = WdcnnLayers::convolutions[i];
    at = c.output_length(at);
    sum += (i == 0 ? 2. : 3.) * 2. * static_cast<double>(at * c.outputs * c.fan_in());
    at /= WdcnnLayers::pooling;
  }
  return sum +
         6. * WdcnnLayers::hidden * static_cast<double>(WdcnnLayers::features(length) + classes);
}

/// Windows a second with LibTorch, which is measured first.
double libtorch_rate = 0;

/// Returns windows a second.
double train(benchmark::State& state, const MakeWdcnnBackend& make_backend) {
  const LabelledWindows train = noise(windows);
  const LabelledWindows test = noise(2);
  WdcnnOptions options;
  options.epochs = 10;  // over which the start is spread
  options.batch = 32;
  double trained = 0;
  const double start = bench::processor_seconds();
  for ([[maybe_unused]] auto _ : state) {
    train_and_test(train, test, options, Stream("bench"), make_backend);
    trained += static_cast<double>(options.epochs) * windows;
  }
  const double rate = trained / (bench::processor_seconds() - start);
  state.counters["windows/s"] = benchmark::Counter(trained, benchmark::Counter::kIsRate);
  state.counters["FLOP/s"] =
      benchmark::Counter(trained * operations_per_window(), benchmark::Counter::kIsRate);
  return rate;
}

void wdcnn_libtorch(benchmark::State& state) {
  libtorch_rate = train(state, libtorch_backend("cpu"));
}
BENCHMARK(wdcnn_libtorch)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

void wdcnn_native(benchmark::State& state) {
  const double rate = train(state, make_native_backend);
  if (libtorch_rate > 0) state.counters["times_libtorch"] = rate / libtorch_rate;
}
BENCHMARK(wdcnn_native)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

/// What the core can do at most, nearly: OpenBLAS on a product that fits it.
void sgemm_1024(benchmark::State& state) {
  constexpr std::int64_t n = 1024;
  const torch::Tensor a = torch::rand({n, n});
  const torch::Tensor b = torch::rand({n, n});
  torch::Tensor c = torch::empty({n, n});
  for ([[maybe_unused]] auto _ : state) torch::mm_out(c, a, b);
  state.counters["FLOP/s"] =
      benchmark::Counter(2. * n * n * n, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(sgemm_1024)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace piae::diagnosis

// Times WDCNN's training, batch 32, 545 windows (500 healthy and nine classes of 5). Compares our
// back end for one core with LibTorch's (with our Adam in one pass), and its arithmetic with a
// large matrix product. Rates use processor time, so that other programs on the machine have little
// effect.

#include "diagnosis/wdcnn.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>

#include "bench/machine.hpp"
#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "libtorch/nets/torch.hpp"
#include "libtorch/wdcnn/backend.hpp"

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

/// Returns the number of taps of a convolution that lie on samples of a window, not on its padding.
double taps(const Convolution& c, std::int64_t samples) {
  double count = 0;
  for (std::int64_t i = 0; i < c.output_length(samples); ++i) {
    const std::int64_t first = i * c.stride - c.padding;
    count +=
        static_cast<double>(std::min(first + c.width, samples) - std::max<std::int64_t>(first, 0));
  }
  return count;
}

/// Returns the additions and multiplications of training on a window: a matrix product forward, one
/// for the weight's gradient, and one for the input's gradient, except in the first layer. Ignores
/// everything else, such as batch normalisation and Adam.
double operations_per_window() {
  double sum = 0;
  std::int64_t at = length;
  for (std::size_t i = 0; i < WdcnnLayers::convolutions.size(); ++i) {
    const Convolution& c = WdcnnLayers::convolutions[i];
    sum += (i == 0 ? 2. : 3.) * 2. * taps(c, at) * static_cast<double>(c.inputs * c.outputs);
    at = c.output_length(at) / WdcnnLayers::pooling;
  }
  return sum +
         6. * WdcnnLayers::hidden * static_cast<double>(WdcnnLayers::features(length) + classes);
}

/// Floating point operations per second of the last matrix product timed.
double product_flops_per_s = 0;

/// Times OpenBLAS on a product that suits it: almost the core's maximum.
void sgemm_1024(benchmark::State& state) {
  constexpr std::int64_t n = 1024;
  const torch::Tensor a = torch::rand({n, n});
  const torch::Tensor b = torch::rand({n, n});
  torch::Tensor c = torch::empty({n, n});
  const double start = bench::processor_seconds();
  while (state.KeepRunning()) torch::mm_out(c, a, b);
  product_flops_per_s = 2.0 * n * n * n * static_cast<double>(state.iterations()) /
                        (bench::processor_seconds() - start);
  state.counters["flop/s"] = product_flops_per_s;
}
BENCHMARK(sgemm_1024)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

/// Windows per second with LibTorch, which is measured before our own back end.
double libtorch_rate = 0;

/// Returns windows per second.
double train(benchmark::State& state, const MakeWdcnnBackend& make_backend) {
  const LabelledWindows train = noise(windows);
  WdcnnOptions options;
  options.epochs = 10;  // spreads the startup cost
  options.batch = 32;
  const double start = bench::processor_seconds();
  while (state.KeepRunning()) {
    (void)train_wdcnn(train, options, Stream("bench"), make_backend);
  }
  const auto trained = static_cast<double>(state.iterations() * options.epochs) * windows;
  const double rate = trained / (bench::processor_seconds() - start);
  const double flops_per_s = rate * operations_per_window();
  state.counters["windows/s"] = rate;
  state.counters["flop/s"] = flops_per_s;
  if (product_flops_per_s > 0) state.counters["of_product"] = flops_per_s / product_flops_per_s;
  return rate;
}

void wdcnn_libtorch(benchmark::State& state) {
  libtorch_rate = train(state, libtorch::wdcnn_on(Device::cpu));
}
BENCHMARK(wdcnn_libtorch)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

void wdcnn_native(benchmark::State& state) {
  const double rate = train(state, make_one_core_backend);
  if (libtorch_rate > 0) state.counters["times_libtorch"] = rate / libtorch_rate;
}
BENCHMARK(wdcnn_native)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace piae::diagnosis

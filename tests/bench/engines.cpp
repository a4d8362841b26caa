// WDCNN's training by our own back end and by the field's engines: oneDNN, which computes the whole
// network, and libxsmm, which computes matrix products. Batch 32, 544 windows, one core. Rates use
// processor time, so that other programs on the machine have little effect.

#include <benchmark/benchmark.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/engines/backend.hpp"
#include "bench/engines/libxsmm.hpp"
#include "bench/machine.hpp"
#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/wdcnn.hpp"

namespace piae::bench {
namespace {

constexpr std::int64_t batch = 32;
constexpr std::size_t windows = 17 * batch;
constexpr std::size_t length = 1024;
constexpr std::size_t classes = 10;

diagnosis::LabelledWindows noise() {
  Stream stream("bench/engines");
  diagnosis::LabelledWindows set;
  set.length = length;
  set.classes = classes;
  for (std::size_t i = 0; i < windows * length; ++i) {
    set.samples.push_back(static_cast<float>(stream.normal(0, 1)));
  }
  for (std::size_t i = 0; i < windows; ++i) {
    set.labels.push_back(static_cast<std::int32_t>(i % classes));
  }
  return set;
}

diagnosis::Training trained(std::int64_t epochs, const diagnosis::MakeWdcnnBackend& make_backend) {
  diagnosis::WdcnnOptions options;
  options.epochs = epochs;
  options.batch = batch;
  return diagnosis::train_wdcnn(noise(), options, Stream("bench"), make_backend).training;
}

/// An engine that computes something else must not be timed: the losses of two epochs must agree.
/// Rounding grows from step to step.
void require_equal_losses(const diagnosis::MakeWdcnnBackend& make_backend) {
  const std::vector<double> ours = trained(2, diagnosis::make_one_core_backend).loss;
  const std::vector<double> theirs = trained(2, make_backend).loss;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (std::abs(theirs[i] - ours[i]) > 0.01 * ours[i]) {
      throw std::logic_error("epoch " + std::to_string(i + 1) + ": loss " +
                             std::to_string(theirs[i]) + " instead of " + std::to_string(ours[i]));
    }
  }
}

/// Returns windows per second.
double train(benchmark::State& state, const diagnosis::MakeWdcnnBackend& make_backend) {
  constexpr std::int64_t epochs = 20;  // spreads the startup cost
  const double start = processor_seconds();
  while (state.KeepRunning()) (void)trained(epochs, make_backend);
  const auto count = static_cast<double>(state.iterations() * epochs) * windows;
  const double rate = count / (processor_seconds() - start);
  state.counters["windows/s"] = rate;
  return rate;
}

double our_rate = 0;

void wdcnn_ours(benchmark::State& state) {
  our_rate = train(state, diagnosis::make_one_core_backend);
}
BENCHMARK(wdcnn_ours)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

void wdcnn_onednn(benchmark::State& state) {
  require_equal_losses(make_onednn_backend);
  const double rate = train(state, make_onednn_backend);
  if (our_rate > 0) state.counters["ours_is_faster_by"] = our_rate / rate;
}
BENCHMARK(wdcnn_onednn)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

// ---- products ----------------------------------------------------------------------------------

using diagnosis::TimeConvolution;

/// The convolutions and dense layers of WDCNN, as our back end computes them.
const std::vector<TimeConvolution>& layers() {
  static const std::vector<TimeConvolution> all{
      {.inputs = 16, .outputs = 16, .width = 4, .padding = 0, .input_length = 67},
      {.inputs = 16, .outputs = 32, .width = 3, .padding = 1, .input_length = 32},
      {.inputs = 32, .outputs = 64, .width = 3, .padding = 1, .input_length = 16},
      {.inputs = 64, .outputs = 64, .width = 3, .padding = 1, .input_length = 8},
      {.inputs = 64, .outputs = 64, .width = 3, .padding = 0, .input_length = 4},
      {.inputs = 64, .outputs = 112, .width = 1, .padding = 0, .input_length = 1},
      {.inputs = 112, .outputs = 16, .width = 1, .padding = 0, .input_length = 1},
  };
  return all;
}

/// Arrays of one layer, with random numbers.
struct Arrays {
  explicit Arrays(const TimeConvolution& shape)
      : input(random(shape.input_length * batch * shape.inputs)),
        weight(random(shape.weights())),
        output(random(shape.output_length() * batch * shape.outputs)),
        by_output(random(shape.output_length() * batch * shape.outputs)),
        by_weight(random(shape.weights())),
        by_input(random(shape.input_length * batch * shape.inputs)),
        transposed(random(shape.weights())) {}

  static std::vector<float> random(std::int64_t size) {
    Stream stream("bench/products");
    std::vector<float> numbers(static_cast<std::size_t>(size));
    for (float& number : numbers) number = static_cast<float>(stream.normal(0, 1));
    return numbers;
  }

  std::vector<float> input, weight, output, by_output, by_weight, by_input, transposed;
};

struct Ours {
  static void run(const TimeConvolution& shape, Arrays& arrays, bool first) {
    diagnosis::convolve<float>(shape, batch, arrays.input.data(), arrays.weight.data(),
                               arrays.output.data());
    diagnosis::weight_gradient<float>(shape, batch, arrays.input.data(), arrays.by_output.data(),
                                      arrays.by_weight.data());
    if (first) return;
    diagnosis::input_gradient<float>(shape, batch, arrays.weight.data(), arrays.by_output.data(),
                                     arrays.transposed.data(), arrays.by_input.data());
  }
};

struct Libxsmm {
  static void run(const TimeConvolution& shape, Arrays& arrays, bool first) {
    libxsmm::convolve(shape, batch, arrays.input.data(), arrays.weight.data(),
                      arrays.output.data());
    libxsmm::weight_gradient(shape, batch, arrays.input.data(), arrays.by_output.data(),
                             arrays.by_weight.data());
    if (first) return;
    libxsmm::input_gradient(shape, batch, arrays.weight.data(), arrays.by_output.data(),
                            arrays.transposed.data(), arrays.by_input.data());
  }
};

void require_equal(const std::vector<float>& ours, const std::vector<float>& theirs) {
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (std::abs(ours[i] - theirs[i]) > 1e-3F * (1 + std::abs(ours[i]))) {
      throw std::logic_error("number " + std::to_string(i) + " is " + std::to_string(theirs[i]) +
                             " instead of " + std::to_string(ours[i]));
    }
  }
}

void require_equal_products() {
  for (const TimeConvolution& shape : layers()) {
    Arrays ours(shape);
    Arrays theirs(shape);
    Ours::run(shape, ours, false);
    Libxsmm::run(shape, theirs, false);
    require_equal(ours.output, theirs.output);
    require_equal(ours.by_weight, theirs.by_weight);
    require_equal(ours.by_input, theirs.by_input);
  }
}

/// Times the products of one training step. Returns windows per second.
template <class Engine>
double multiply(benchmark::State& state) {
  std::vector<Arrays> arrays(layers().begin(), layers().end());
  const double start = processor_seconds();
  while (state.KeepRunning()) {
    for (std::size_t i = 0; i < arrays.size(); ++i) Engine::run(layers()[i], arrays[i], i == 0);
    benchmark::ClobberMemory();
  }
  const double rate =
      static_cast<double>(state.iterations() * batch) / (processor_seconds() - start);
  state.counters["windows/s"] = rate;
  return rate;
}

double our_products = 0;

void products_ours(benchmark::State& state) { our_products = multiply<Ours>(state); }
BENCHMARK(products_ours)->MeasureProcessCPUTime()->Unit(benchmark::kMicrosecond);

void products_libxsmm(benchmark::State& state) {
  require_equal_products();
  const double rate = multiply<Libxsmm>(state);
  if (our_products > 0) state.counters["ours_is_faster_by"] = our_products / rate;
}
BENCHMARK(products_libxsmm)->MeasureProcessCPUTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace piae::bench

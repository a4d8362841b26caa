// Training of the methods on dense networks as on CWRU, 45 known windows of 1024 samples in batches
// of 5, at their default sizes: LibTorch's eager operations (with our Adam in one pass) and, after
// it, our own back end. Rates are by the processor's time.
//
// What a step must move at least: a weight is read forward and backward, 4 bytes each, and read and
// written by Adam with its two moments, 24 bytes. "of_copy" is what our step moves a second of what
// a copy of an array as large as the weights moves in the same run. Of these 32 bytes 20 are read,
// and reading is what a core waits for: "of_reading" is what the step reads a second of what a core
// reads that does nothing else with an array as large as weights and moments together.

#include <benchmark/benchmark.h>

#include <map>

#include "augment/catalogue.hpp"
#include "bench/known_windows.hpp"
#include "bench/machine.hpp"
#include "support/command_line.hpp"

namespace piae::augment {
namespace {

constexpr double batch = 5;
constexpr int epochs = 100;  // over which the start is spread

struct Subject {
  const char* method;
  double weights;        ///< of all its networks
  double bytes_of_step;  ///< in the mean
  double read_by_step;   ///< of these
};

/// Weights of a dense chain of depth 3 and width 256.
constexpr double chain(double inputs, double outputs) { return 256 * (inputs + 256 + outputs); }
constexpr double classes = 10;
constexpr double coder = chain(1024, 2) + chain(2 + classes, 1024);
constexpr double twin = coder + chain(2048, 2048);
constexpr double vae = chain(1024 + classes, 20) + chain(10 + classes, 1024);
constexpr double critic = chain(1024 + classes, 1);
constexpr double generator = chain(20 + classes, 1024);
constexpr double taught = 4 + 4 + 24;  // bytes of a weight: forward, backward, Adam
constexpr double read = 4 + 4 + 12;
constexpr double read_by_vae = 4 + 12;  // goes back and learns in one pass
const Subject subjects[] = {
    {"piae-dt", twin, taught* twin, read* twin},
    {"ae", coder, taught* coder, read* coder},
    {"vae", vae, (4 + 24) * vae, read_by_vae* vae},
    // The generator runs in each step, and learns in one of five, through the critic.
    {"wgan-gp", critic + generator,
     taught* critic + 4 * generator + (taught * generator + 8 * critic) / 5,
     read* critic + 4 * generator + (read * generator + 8 * critic) / 5},
};

/// Windows a second by the processor's time.
double train(benchmark::State& state, const Subject& subject, Backend backend) {
  const signal::WindowSet known = bench::known_windows();
  const std::unique_ptr<Method> method = make_method(subject.method);
  cli::parse("--epochs " + std::to_string(epochs),
             [&](const cli::Options& command) { method->bind(command); });
  nets::Checkpoint never;  // no file is there, and these epochs do not take an hour
  never.path = "bench-generators.checkpoint";
  never.interval_s = 3600;
  never.interrupted = [] { return false; };
  const double start = bench::processor_seconds();
  while (state.KeepRunning()) {
    artefact::Writer model("model");
    method->train(known, Stream("bench"), {backend, Device::cpu}, never, model);
  }
  const double trained =
      static_cast<double>(state.iterations()) * epochs * static_cast<double>(known.size());
  const double rate = trained / (bench::processor_seconds() - start);
  state.counters["windows/s"] = rate;
  return rate;
}

/// By method.
std::map<std::string, double> libtorch_rates;

void by_libtorch(benchmark::State& state, const Subject& subject) {
  libtorch_rates[subject.method] = train(state, subject, Backend::libtorch);
}

void ours(benchmark::State& state, const Subject& subject) {
  const double rate = train(state, subject, Backend::native);
  const double bytes_per_s = rate / batch * subject.bytes_of_step;
  const auto size = static_cast<std::size_t>(4 * subject.weights);
  state.counters["bytes/s"] = bytes_per_s;
  state.counters["of_copy"] = bytes_per_s / bench::copied_bytes_per_s(size);
  state.counters["of_reading"] =
      rate / batch * subject.read_by_step / bench::read_bytes_per_s(3 * size);
  if (libtorch_rates.contains(subject.method)) {
    state.counters["times_libtorch"] = rate / libtorch_rates.at(subject.method);
  }
}

[[maybe_unused]] const bool registered = [] {
  for (const Subject& subject : subjects) {
    const std::string name = subject.method;
    benchmark::RegisterBenchmark((name + "_libtorch").c_str(), by_libtorch, subject)
        ->MeasureProcessCPUTime()
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark((name + "_native").c_str(), ours, subject)
        ->MeasureProcessCPUTime()
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace piae::augment

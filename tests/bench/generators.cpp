// Times the training of the network methods as on CWRU, 45 known windows of 1024 samples in batches
// of 5, at their default sizes: first LibTorch's eager operations (with our Adam in one pass), then
// our own back end. Rates use processor time.
//
// Memory traffic limits dense layers. Each weight is read forward and backward, 4 bytes each, and
// read and written by Adam with its two moments, 24 bytes. "of_copy" is the memory traffic of our
// step per second, relative to copying an array as large as the weights in the same run. 20 of the
// 32 bytes are reads, and a core waits for reads. "of_reading" is the read rate of the step,
// relative to a core that only reads an array as large as weights and moments together.
//
// Layers on frames use a weight at each frame, so arithmetic limits them. "of_limit" is the least
// time of our step (its products at the speed of a large one, its bytes at that of a copy),
// relative to the measured time.

#include <benchmark/benchmark.h>

#include <map>

#include "augment/catalogue.hpp"
#include "bench/known_windows.hpp"
#include "bench/machine.hpp"
#include "libtorch/nets/torch.hpp"
#include "support/command_line.hpp"

namespace piae::augment {
namespace {

constexpr double batch = 5;
constexpr int epochs = 100;  // spreads the startup cost

struct Subject {
  const char* method;
  double weights;            ///< weights of all its networks
  double bytes_of_step;      ///< mean bytes that a step moves
  double read_by_step;       ///< mean bytes that a step reads
  double flops_of_step = 0;  ///< mean operations of its products; 0 if memory is the limit
};

/// Returns the number of weights of a dense chain of depth 3 and width 256.
constexpr double chain(double inputs, double outputs) { return 256 * (inputs + 256 + outputs); }
constexpr double classes = 10;
constexpr double coder = chain(1024, 2) + chain(2 + classes, 1024);
constexpr double module = chain(2048, 2048);
constexpr double twin = coder + module;
constexpr double vae = chain(1024 + classes, 20) + chain(10 + classes, 1024);
constexpr double critic = chain(1024 + classes, 1);
constexpr double generator = chain(20 + classes, 1024);
constexpr double taught = 4 + 4 + 24;  // bytes per weight: forward, backward, Adam
// Two convolutions, 8 samples wide, of 1 to 16 to 32 channels, a dense layer, and their mirror
// image. Their products, 20 million operations a step, take longer than their bytes, but little
// compared with those of the module.
constexpr double convolutional =
    chain(2048, 2048) + 2 * 8 * (1 * 16 + 16 * 32) + 2048 * (2 + 2 + classes);

// Multiplications per window in piae-dt-rnn: its layers of 96 units over 32 frames (at the first
// frame the state is zero).
constexpr double gates = 3 * 96;
constexpr double layer(double inputs, double input_frames) {
  return gates * (inputs * input_frames + 96 * 31);
}
constexpr double encoder = layer(32, 32) + layer(96, 32) + 96 * 2;
constexpr double decoder = layer(2 + classes, 1) + layer(96, 32) + 96 * 32 * 32;
// Operations per step: forward, for the parameters, and back (not to the windows, and twice through
// the decoder in Stage 1, which is every other epoch).
constexpr double products = 2 * batch * (3 * encoder - gates * 32 * 32 + 3.5 * decoder);
constexpr double recurrent_weights = gates * (32 + 2 + classes + 6 * 96) + 96 * (2 + 32);

// Multiplications per window and weights of each layer, in piae-dt-tcn (64 frames of 16 samples, 32
// channels, two blocks of two convolutions with 3 taps) and in piae-dt-transformer (32 frames of
// 32, two blocks of attention and dense layers of 128).
constexpr double convolutions = 4 * 3 * 32 * 32;
constexpr double convolved_frames = 64 * 16 * 32;
constexpr double blocks = 2 * (4 * 32 * 32 + 2 * 32 * 128);
constexpr double attended = 2 * 2 * 32 * 32 * 32;  // scores and sums of values
constexpr double attended_frames = 32 * 32 * 32;
constexpr double first_layer = (2 + classes) * 64 * 32;  // temporal decoder

/// Adds forward, parameter and backward passes (backward not to the windows, and twice through the
/// decoder in Stage 1, which is every other epoch).
constexpr double passes(double encoder, double encoder_frames, double decoder) {
  return 3 * encoder + 2 * encoder_frames + 3.5 * decoder;
}
constexpr double temporal =
    passes(64 * convolutions, convolved_frames, first_layer + 64 * convolutions + convolved_frames);
constexpr double temporal_weights = 2 * convolutions + first_layer + 2 * 16 * 32;
constexpr double transformer =
    passes(32 * blocks + attended, attended_frames, 32 * blocks + attended + attended_frames);
constexpr double transformer_weights = 2 * blocks + 4 * 32 * 32;

constexpr double read = 4 + 4 + 12;
// Backward pass and learning in one pass save one read.
constexpr double taught_in_passing = taught - 4;
constexpr double read_in_passing = read - 4;

const Subject subjects[] = {
    {"piae-dt", twin, taught* twin, read* twin},
    {"ae", coder, taught* coder, read* coder},
    {"piae-dt-cnn", convolutional, taught* convolutional, read* convolutional},
    {"piae-dt-rnn", module + recurrent_weights, taught*(module + recurrent_weights),
     read*(module + recurrent_weights), products},
    {"piae-dt-tcn", module + temporal_weights, taught*(module + temporal_weights),
     read*(module + temporal_weights), 2 * batch* temporal},
    {"piae-dt-transformer", module + transformer_weights, taught*(module + transformer_weights),
     read*(module + transformer_weights), 2 * batch* transformer},
    {"vae", vae, taught_in_passing* vae, read_in_passing* vae},
    // The generator runs in each step, and learns in one of five, through the critic.
    {"wgan-gp", critic + generator,
     taught* critic + 4 * generator + (taught_in_passing * generator + 8 * critic) / 5,
     read* critic + 4 * generator + (read_in_passing * generator + 8 * critic) / 5},
};

/// Returns windows per second of processor time.
double train(benchmark::State& state, const Subject& subject, Backend backend) {
  const signal::WindowSet known = bench::known_windows();
  const std::unique_ptr<Method> method = make_method(subject.method);
  cli::parse("--epochs " + std::to_string(epochs),
             [&](const cli::Options& command) { method->bind(command); });
  nets::Checkpoint never;  // no file exists, and these epochs take less than an hour
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

/// Rates by method.
std::map<std::string, double> libtorch_rates;

void by_libtorch(benchmark::State& state, const Subject& subject) {
  libtorch_rates[subject.method] = train(state, subject, Backend::libtorch);
}

/// Returns the operations per second of OpenBLAS on a product that suits it: almost the core's
/// maximum.
double large_product_flops_per_s() {
  constexpr std::int64_t n = 1024;
  constexpr int rounds = 20;
  const torch::Tensor a = torch::rand({n, n});
  const torch::Tensor b = torch::rand({n, n});
  torch::Tensor c = torch::mm(a, b);
  const double start = bench::processor_seconds();
  for (int i = 0; i < rounds; ++i) torch::mm_out(c, a, b);
  return 2.0 * n * n * n * rounds / (bench::processor_seconds() - start);
}

void ours(benchmark::State& state, const Subject& subject) {
  const double rate = train(state, subject, Backend::native);
  const double steps_per_s = rate / batch;
  const double bytes_per_s = steps_per_s * subject.bytes_of_step;
  const double copied_per_s =
      bench::copied_bytes_per_s(static_cast<std::size_t>(4 * subject.weights));
  state.counters["bytes/s"] = bytes_per_s;
  if (subject.flops_of_step > 0) {
    const double product_per_s = large_product_flops_per_s();
    const double least_s =
        subject.flops_of_step / product_per_s + subject.bytes_of_step / copied_per_s;
    state.counters["flop/s"] = steps_per_s * subject.flops_of_step;
    state.counters["of_product"] = steps_per_s * subject.flops_of_step / product_per_s;
    state.counters["of_limit"] = steps_per_s * least_s;
  } else {
    state.counters["of_copy"] = bytes_per_s / copied_per_s;
    state.counters["of_reading"] =
        steps_per_s * subject.read_by_step /
        bench::read_bytes_per_s(static_cast<std::size_t>(12 * subject.weights));
  }
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

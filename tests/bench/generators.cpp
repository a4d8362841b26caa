// Ten training epochs of the VAE and the WGAN-GP as on CWRU, at their default sizes.

#include <benchmark/benchmark.h>

#include "augment/method.hpp"
#include "command_line.hpp"
#include "known_windows.hpp"

namespace piae::augment {
namespace {

void generator_training(benchmark::State& state, const std::string& name) {
  const signal::WindowSet known = known_windows();
  const std::unique_ptr<Method> method = make_method(name);
  cli::parse("--epochs 10", [&](const cli::Options& command) { method->bind(command); });
  nets::Checkpoint never;  // no file is there, and ten epochs do not take an hour
  never.path = "bench-generators.checkpoint";
  never.interval_s = 3600;
  never.interrupted = [] { return false; };
  while (state.KeepRunning()) {
    artefact::Writer model("model");
    method->train(known, Stream("bench"), {}, never, model);
  }
  state.counters["windows/s"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * 10 * static_cast<double>(known.size()),
      benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(generator_training, vae, "vae")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(generator_training, wgan_gp, "wgan-gp")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace piae::augment

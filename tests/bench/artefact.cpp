// Times writing and reading E.h5 of CWRU: 9 classes of 495 windows of 1024 samples, 18 MB. Both
// include the digests; writing includes the sync to the disk.

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/random.hpp"
#include "signal/window_set.hpp"

namespace {

using namespace piae;
namespace fs = std::filesystem;

signal::WindowSet window_set() {
  signal::WindowSet set;
  set.info.name = "bench";
  set.info.sample_rate_hz = 12000;
  set.info.shaft_speed_rpm = 1800;
  set.length = 1024;
  Stream stream("bench/artefact");
  for (std::int32_t label = 0; label < 9; ++label) {
    const signal::Defect defect = label == 0 ? signal::Defect::none : signal::Defect::other;
    set.info.classes.push_back({"class" + std::to_string(label), defect, 0});
    set.labels.insert(set.labels.end(), 495, label);
  }
  set.samples.resize(set.size() * set.length);
  for (float& sample : set.samples) sample = static_cast<float>(stream.normal(0, 1));
  return set;
}

void write_file(const signal::WindowSet& set, const fs::path& path) {
  artefact::Writer writer("windows");
  signal::write(writer, set);
  writer.save(path, {"bench", "", {}});
}

fs::path file_of_this_process() {
  return fs::temp_directory_path() / ("piae-bench-" + std::to_string(getpid()) + ".h5");
}

void count_bytes(benchmark::State& state, const signal::WindowSet& set) {
  state.SetBytesProcessed(state.iterations() *
                          static_cast<std::int64_t>(set.samples.size() * sizeof(float)));
}

void write_window_set(benchmark::State& state) {
  const signal::WindowSet set = window_set();
  const fs::path path = file_of_this_process();
  while (state.KeepRunning()) write_file(set, path);
  fs::remove(path);
  count_bytes(state, set);
}

void read_window_set(benchmark::State& state) {
  const signal::WindowSet set = window_set();
  const fs::path path = file_of_this_process();
  write_file(set, path);
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(signal::read_window_set(artefact::Reader(path, "windows")));
  }
  fs::remove(path);
  count_bytes(state, set);
}

BENCHMARK(write_window_set)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(read_window_set)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

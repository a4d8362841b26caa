// Times a kept classifier on a recording: windows of 1024 samples per second on one core, WDCNN on
// the waveform and on spectra, compared with reading the same recording from a file. Rates use
// processor time, so that other programs on the machine have little effect.

#include <benchmark/benchmark.h>

#include <filesystem>

#include "artefact/writer.hpp"
#include "bench/machine.hpp"
#include "classification/recording.hpp"
#include "diagnosis/keep.hpp"
#include "diagnosis/learn.hpp"
#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/training_set.hpp"
#include "raw/file.hpp"

namespace piae::classification {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t length = 1024;
constexpr std::size_t windows_in_file = 20'000;

signal::DatasetInfo ten_classes() {
  signal::DatasetInfo info;
  info.name = "bench";
  info.sample_rate_hz = 12000;
  info.shaft_speed_rpm = 1800;
  info.bearing = {.balls = 9,
                  .ball_diameter_mm = 7.94,
                  .pitch_diameter_mm = 39.04,
                  .inner_raceway_mm = 31.1,
                  .outer_raceway_mm = 46.98,
                  .contact_angle_deg = 0};
  info.classes.push_back({"Normal", signal::Defect::none, 0});
  for (int i = 0; i < 9; ++i) {
    info.classes.push_back({"fault" + std::to_string(i), signal::Defect::outer, 0.2});
  }
  return info;
}

std::vector<double> noise(std::size_t samples) {
  Stream stream("bench/classify");
  std::vector<double> signal(samples);
  for (double& sample : signal) sample = stream.normal(0, 1);
  return signal;
}

signal::WindowSet noise_windows(std::size_t healthy, std::size_t of_each_fault) {
  signal::WindowSet windows;
  windows.info = ten_classes();
  windows.length = length;
  for (const Label label : windows.info.labels()) {
    windows.labels.insert(windows.labels.end(), label == 0 ? healthy : of_each_fault, label);
  }
  for (const double sample : noise(windows.labels.size() * length)) {
    windows.samples.push_back(static_cast<float>(sample));
  }
  return windows;
}

/// Returns a classifier for the paper's task: 500 healthy windows, and 5 of each of nine faults.
/// Its accuracy does not matter here.
diagnosis::KeptClassifier kept(const std::string& name) {
  const diagnosis::Classifier& classifier = diagnosis::the_classifier(name);
  const signal::WindowSet normal = noise_windows(500, 0);
  const signal::WindowSet known = noise_windows(0, 5);
  const signal::WindowSet training = diagnosis::compose_training_set(normal, known, nullptr, 0);
  const Stream stream("bench");
  const diagnosis::LearningSettings settings{.wdcnn = {.epochs = 1},
                                             .make_backend = diagnosis::make_one_core_backend};
  diagnosis::Learned learned = diagnosis::learn(classifier, normal, training, settings, stream);
  return diagnosis::keep(classifier, std::move(learned.trained), training,
                         {.normal = normal, .known = known, .generated = nullptr},
                         {.settings = settings, .stream = stream, .epoch_done = {}},
                         {.method = "none", .ratio = "100to1", .training_digest = ""});
}

/// Seconds to read a window from a file, measured before the classifiers.
double reading_s = 0;

void read_recording(benchmark::State& state) {
  const fs::path file = fs::temp_directory_path() / "piae-bench-classify.h5";
  artefact::Writer writer("records");
  writer.numbers("/x", noise(windows_in_file * length));
  writer.save(file, {});
  const double start = bench::processor_seconds();
  while (state.KeepRunning()) benchmark::DoNotOptimize(raw::read_here(file, "/x"));
  reading_s = (bench::processor_seconds() - start) / static_cast<double>(state.iterations()) /
              windows_in_file;
  state.counters["windows/s"] = 1 / reading_s;
  fs::remove(file);
}
BENCHMARK(read_recording)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

void classify(benchmark::State& state, const std::string& name) {
  diagnosis::KeptClassifier classifier = kept(name);
  const Recording recording{.name = "noise",
                            .shaft_speed_rpm = 1800,
                            .true_class = "",
                            .signal = noise(windows_in_file * length / 10)};
  const double start = bench::processor_seconds();
  while (state.KeepRunning()) {
    const signal::WindowSet windows = windows_of(recording, classifier.info(), length, length);
    benchmark::DoNotOptimize(classifier.predict(windows));
  }
  const double window_s = (bench::processor_seconds() - start) /
                          static_cast<double>(state.iterations()) /
                          (static_cast<double>(windows_in_file) / 10);
  state.counters["windows/s"] = 1 / window_s;
  state.counters["times_reading"] = window_s / reading_s;
}
BENCHMARK_CAPTURE(classify, wdcnn, "wdcnn")->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(classify, wdcnn_spectra, "wdcnn-spectra")
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(classify, nearest, "nearest")
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace piae::classification

// Compares generated windows with real ones.

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/stage.hpp"
#include "scoring/quality_record.hpp"
#include "signal/roles.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

std::int64_t windows_of(const scoring::QualityRecord& record) {
  std::int64_t windows = 0;
  for (const scoring::ClassQuality& quality : record.classes) windows += quality.windows;
  return windows;
}

/// Names the classes without a fault line.
std::string without_line(const scoring::QualityRecord& record) {
  std::string names;
  for (const scoring::ClassQuality& quality : record.classes) {
    if (scoring::has_line(record.info, quality.label)) continue;
    names += (names.empty() ? "" : ", ") + record.info.class_of(quality.label).name;
  }
  return names.empty() ? "" : " (without fault line: " + names + ", because the defect is 'other')";
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage("score",
                   "Compares the generated windows of each class with real windows that no "
                   "generator has used: MMD² (no unit), RMSE as in the paper and after the best "
                   "circular shift (unit of the recordings), ratio of RMS amplitudes (generated "
                   "/ real), log-spectral distance (dB), and the excess of the class's own fault "
                   "lines in the envelope spectrum (dB; also minus that of real windows).",
                   "score --generated E.h5 --real D.h5 --output score.h5");
  fs::path generated_file;
  fs::path real_file;
  fs::path output;
  stage.input_file("--generated", generated_file, "generated windows, E.h5 of generate");
  stage.input_file("--real", real_file, "hidden real windows, D.h5 of split");
  stage.output_file("--output", output, "metrics of each class, score.h5");

  return stage.run(argc, argv, [&] {
    const artefact::Reader generated = stage.open("generated", generated_file, "windows");
    const artefact::Reader real = stage.open("real", real_file, "windows");
    signal::require_role(generated, signal::Role::generated);
    signal::require_role(real, signal::Role::hidden);
    scoring::QualityRecord record;
    record.method = signal::read_method(generated);
    record.seed = generated.integer("/", "seed");
    record.protocol = signal::read_protocol(generated);
    signal::require_same_split(generated, real);
    const signal::WindowSet real_windows = signal::read_window_set(real);
    record.info = real_windows.info;
    record.classes = scoring::quality_by_class(signal::read_window_set(generated), real_windows);

    artefact::Writer writer("score");
    scoring::write(writer, record);
    stage.save(writer, output);
    std::cout << fmt::format("scored {} windows of {} classes{}: {}\n", windows_of(record),
                             record.classes.size(), without_line(record), output.string());
  });
}

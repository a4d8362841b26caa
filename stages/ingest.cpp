// Reads raw recordings, checks them, and writes them as one artefact.

#include "signal/ingest.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iostream>

#include "cli/progress.hpp"
#include "cli/stage.hpp"
#include "inspection/check.hpp"
#include "inspection/picture.hpp"
#include "inspection/report.hpp"
#include "signal/described_split.hpp"
#include "signal/estimated_speeds.hpp"
#include "text/file.hpp"

namespace fs = std::filesystem;
using namespace piae;

namespace {

/// Prints the findings, and draws the picture if its file is named.
void check_files(const signal::Description& description, const fs::path& data_dir,
                 const fs::path& picture) {
  cli::Progress progress("check", "records", description.records.size());
  const inspection::DatasetCheck check =
      inspection::check(description, data_dir, [&](std::size_t done) { progress.update(done); });
  std::cout << inspection::report_of(description, check);
  if (!picture.empty()) {
    text::save_all({{picture, inspection::picture_of(description.info, check)}});
  }
  if (check.exit != Exit::done) {
    throw Error(check.exit, "data set " + description.info.name +
                                " has problems, see above; correct its description or its files");
  }
}

/// Takes the speeds from the signals and from what was recorded next to them, if the description
/// asks for it. Returns a line about those from the signals.
std::string speeds_of_signals(signal::Description& description, const fs::path& data_dir) {
  const auto reads = [&](const signal::RecordSource& source) {
    return reads_for_speed(description, source);
  };
  const auto read = static_cast<std::size_t>(std::ranges::count_if(description.records, reads));
  if (read == 0) return "";
  cli::Progress progress("speeds", "records", read);
  std::size_t done = 0;
  const auto [found, lowest, highest] =
      signal::use_speeds_of_signals(description, data_dir, [&] { progress.update(++done); });
  if (description.speed_search_percent == 0) return "";
  return fmt::format(
      "speeds: {} of {} from the signals, {:+.1f} to {:+.1f} % of the given ones, the others as "
      "given\n",
      found, description.records.size(), 100 * (lowest - 1), 100 * (highest - 1));
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "ingest",
      "Reads the raw recordings of a data set (text, MATLAB, HDF5, NumPy, TDMS, UFF, LabVIEW, "
      "sound), checks them, resamples them to one rate and writes them as one artefact.",
      "ingest --description pipeline/datasets/cwru.toml --data-dir data --output records.h5");
  fs::path file;
  fs::path data_dir = "data";
  fs::path output;
  fs::path picture;
  bool sources = false;
  bool check = false;
  stage.input_file("--description", file, "Data set description (TOML)");
  stage.input_file("--data-dir", data_dir, "Folder with the files that --description names")
      .required(false);
  stage.output_file("--output", output, "Artefact to write (needed unless --check or --sources)")
      .required(false);
  stage.file_flag("--sources", sources, "Print 'sha256  file  url' of each raw file and stop");
  stage.file_flag(
      "--check", check,
      "Read all recordings, report findings, warnings and problems, and write no artefact");
  stage.output_file("--picture", picture, "With --check: draw the recordings into this file (SVG)")
      .required(false);

  return stage.run(argc, argv, [&] {
    if (sources) {
      std::cout << signal::list_of_sources(file, data_dir);
      return;
    }
    signal::Description description = signal::read_description(file);
    stage.note_read(file);
    for (const std::string& name : recordings_of(description, data_dir)) {
      stage.note_read(data_dir / name);
    }
    stage.require_no_input(check ? picture : output);
    if (check) {
      signal::require_sensible_split(description, file);
      return check_files(description, data_dir, picture);
    }
    if (!picture.empty()) throw Error(Exit::usage, "--picture needs --check (see ingest --help)");
    if (output.empty()) throw Error(Exit::usage, "--output is required (see ingest --help)");
    stage.note_input("description", file);
    cli::release_freed_memory();
    const std::string speeds = speeds_of_signals(description, data_dir);
    artefact::Writer writer("records");
    signal::RecordingsWriter recordings(writer, description.info);
    cli::Progress progress("ingest", "records", description.records.size());
    std::size_t records = 0;
    signal::ingest(description, data_dir, [&](const signal::Record& record) {
      recordings.add(record);
      progress.update(++records);
      for (const signal::SourceFile& recording : record.files) {
        stage.note_input("recording", recording.name, recording.sha256);
      }
    });
    recordings.finish();
    stage.save(writer, output);
    std::cout << fmt::format("ingest: {} records, {} samples at {:g} Hz\n{}", records,
                             recordings.samples(), description.info.sample_rate_hz, speeds);
  });
}

#include "signal/ingest.hpp"

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "base/error.hpp"
#include "cli/progress.hpp"
#include "cli/stage.hpp"
#include "signal/check.hpp"
#include "text/table.hpp"

namespace fs = std::filesystem;
using namespace piae;

namespace {

void print_sources(const signal::Description& description) {
  const auto or_dash = [](const std::string& text) { return text.empty() ? "-" : text; };
  for (const signal::RecordSource& source : description.records) {
    std::cout << or_dash(source.sha256) << "  " << source.file << "  " << or_dash(source.url)
              << '\n';
  }
}

signal::Recordings read_raw_files(const signal::Description& description, const fs::path& folder) {
  cli::Progress progress("ingest", "records", description.records.size());
  return signal::ingest(description, folder, [&](std::size_t done) { progress.update(done); });
}

/// Prints what was found as tables, and then each problem in a line of its own.
void print_check(const signal::Description& description, const signal::DatasetCheck& check) {
  const signal::DatasetInfo& info = description.info;
  text::Table records({"record", "file", "Hz", "samples", "s", "rpm", "RMS"}, 2);
  for (const signal::RecordCheck& record : check.records) {
    const signal::RecordSource& source = record.source;
    const auto samples = static_cast<double>(record.samples);
    if (!record.problem.empty()) {
      records.row({source.name, source.file, "unreadable"});
      continue;
    }
    records.row({source.name, source.file, fmt::format("{:g}", source.sample_rate_hz),
                 std::to_string(record.samples),
                 fmt::format("{:.2f}", samples / info.sample_rate_hz),
                 fmt::format("{:g}", source.shaft_speed_rpm), fmt::format("{:.4g}", record.rms)});
  }
  text::Table classes({"class", "defect", "mm", "records", "stride"}, 2);
  for (const signal::ClassCheck& c : check.classes) {
    const signal::ClassInfo& described = info.class_of(c.label);
    classes.row({described.name, signal::to_string(described.defect),
                 fmt::format("{:g}", described.defect_size_mm), std::to_string(c.records),
                 c.stride > 0 ? std::to_string(c.stride) : "-"});
  }
  std::cout << fmt::format("{}, samples at {:g} Hz\n\n{}\n{}", info.name, info.sample_rate_hz,
                           records.plain(), classes.plain());
  for (const auto& record : check.records) {
    if (!record.problem.empty()) std::cout << record.problem << '\n';
  }
  for (const auto& c : check.classes) {
    if (!c.problem.empty()) {
      std::cout << info.class_of(c.label).name << ": " << c.problem << '\n';
    }
  }
}

void check_files(const signal::Description& description, const fs::path& folder) {
  cli::Progress progress("check", "records", description.records.size());
  const signal::DatasetCheck check =
      signal::check(description, folder, [&](std::size_t done) { progress.update(done); });
  print_check(description, check);
  if (check.exit == Exit::done) return;
  throw Error(check.exit, description.info.name + ": cannot be used as it is, see above");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage("ingest",
                   "Reads the raw recordings of a dataset (.mat, .csv, .h5), checks them, brings "
                   "them to one sample rate and writes them as one artefact.",
                   "ingest --description pipeline/datasets/cwru.toml --data-dir data --output "
                   "records.h5");
  fs::path file;
  fs::path data_dir = "data";
  fs::path output;
  bool sources = false;
  bool check = false;
  stage.input_file("--description", file, "Dataset description (TOML)");
  stage.input_file("--data-dir", data_dir, "Folder that holds the files it names").required(false);
  stage.output_file("--output", output, "Artefact to write (needed unless --check or --sources)")
      .required(false);
  stage.file_flag("--sources", sources, "Print 'sha256  file  url' of each raw file and stop");
  stage.file_flag("--check", check,
                  "Read everything, say what was found and what is wrong, and write nothing");

  return stage.run(argc, argv, [&] {
    const signal::Description description = signal::read_description(file);
    if (sources) return print_sources(description);
    if (check) return check_files(description, data_dir);
    if (output.empty()) throw Error(Exit::usage, "--output is required (see ingest --help)");
    stage.note_input("description", file);
    const signal::Recordings recordings = read_raw_files(description, data_dir);
    artefact::Writer writer("records");
    write(writer, recordings);
    stage.save(writer, output);
    std::size_t samples = 0;
    for (const signal::Record& record : recordings.records) samples += record.signal.size();
    std::cout << fmt::format("ingest: {} records, {} samples at {:g} Hz\n",
                             recordings.records.size(), samples, recordings.info.sample_rate_hz);
  });
}

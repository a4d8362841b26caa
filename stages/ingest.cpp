#include "signal/ingest.hpp"

#include <iostream>

#include "base/error.hpp"
#include "cli/progress.hpp"
#include "cli/stage.hpp"

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
  stage.input_file("--description", file, "Dataset description (TOML)");
  stage.input_file("--data-dir", data_dir, "Folder that holds the files it names")->required(false);
  stage.output_file("--output", output, "Artefact to write (needed unless --sources)")
      ->required(false);
  stage.app()
      .add_flag("--sources", sources, "Print 'sha256  file  url' of each raw file and stop")
      ->group("Files");

  return stage.run(argc, argv, [&] {
    const signal::Description description = signal::read_description(file);
    if (sources) return print_sources(description);
    if (output.empty()) throw Error(Exit::usage, "--output is required (see ingest --help)");
    stage.note_input("description", file);
    const signal::Recordings recordings = read_raw_files(description, data_dir);
    artefact::Writer writer("records");
    write(writer, recordings);
    stage.save(writer, output);
    std::size_t samples = 0;
    for (const signal::Record& record : recordings.records) samples += record.signal.size();
    std::cout << "ingest: " << recordings.info.name << ": " << recordings.records.size()
              << " records of " << recordings.info.classes.size() << " classes, " << samples
              << " samples at " << recordings.info.sample_rate_hz << " Hz\n";
  });
}

// Applies a kept classifier to recordings.

#include <iostream>
#include <vector>

#include "classification/picture.hpp"
#include "classification/record.hpp"
#include "classification/texts.hpp"
#include "classification/verdict.hpp"
#include "cli/checks.hpp"
#include "cli/progress.hpp"
#include "cli/stage.hpp"
#include "diagnosis/trust.hpp"
#include "signal/ingest.hpp"
#include "signal/ranges.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

/// Recordings to classify: a single file, or those of a description.
struct Sources {
  classification::LoneFile lone;
  fs::path description;
  fs::path data_dir = "data";
  std::vector<std::string> records;  ///< of the description; all if empty
};

void require_one_source(const Sources& sources) {
  if (sources.lone.file.empty() == sources.description.empty()) {
    throw Error(Exit::usage, "give either --recording or --description");
  }
  const bool complete = sources.lone.sample_rate_hz > 0 && sources.lone.shaft_speed_rpm > 0 &&
                        !sources.lone.variable.empty();
  if (!sources.lone.file.empty() && !complete) {
    throw Error(Exit::usage, "--recording needs --variable, --sample-rate-hz and --speed-rpm");
  }
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "classify",
      "Predicts the fault in recordings with a classifier that `diagnose --keep-classifier` "
      "stored: class and calibrated probability of each window and of the whole recording, or "
      "\"unknown\" if it differs from all trained classes. The picture adds the evidence: the "
      "envelope spectrum with the fault lines of the bearing.",
      "classify --classifier classifier.h5 --recording bearing7.csv --variable 1 "
      "--sample-rate-hz 25600 --speed-rpm 1500 --picture bearing7.svg");
  fs::path classifier_file;
  Sources sources;
  fs::path output;
  fs::path csv;
  fs::path picture;
  std::size_t step = 0;
  stage.input_file("--classifier", classifier_file,
                   "trained classifier, classifier.h5 of diagnose --keep-classifier");
  stage
      .input_file("--recording", sources.lone.file,
                  "one recording: text, MATLAB, HDF5, NumPy, TDMS, UFF, LabVIEW or sound")
      .required(false);
  stage.options().add("--variable", sources.lone.variable,
                      "variable, dataset, column (name or number) or channel of the recording");
  stage.options()
      .add("--sample-rate-hz", sources.lone.sample_rate_hz, "sample rate of the recording, Hz")
      .check(cli::within(signal::ranges::sample_rate_hz));
  stage.options()
      .add("--speed-rpm", sources.lone.shaft_speed_rpm, "shaft speed of the recording, rpm")
      .check(cli::within(signal::ranges::shaft_speed_rpm));
  stage
      .input_file("--description", sources.description,
                  "Dataset description (TOML) of several recordings, instead of --recording")
      .required(false);
  stage.input_file("--data-dir", sources.data_dir, "Folder with the files that --description names")
      .required(false);
  stage.options().add("--record", sources.records,
                      "records of --description to classify (default: all)");
  stage.options()
      .add("--step", step,
           "samples between the starts of successive windows, at the sample rate of the "
           "classifier; 0: the window length")
      .check(cli::whole_number(0, 1'000'000'000));
  stage.output_file("--output", output, "predictions for all windows (HDF5)").required(false);
  stage.output_file("--csv", csv, "predictions for all windows (CSV)").required(false);
  stage.output_file("--picture", picture, "predictions over time and envelope spectra (SVG)")
      .required(false);

  return stage.run(argc, argv, [&] {
    require_one_source(sources);
    const artefact::Reader reader = stage.open("classifier", classifier_file, "classifier");
    diagnosis::KeptClassifier kept(reader);
    const signal::DatasetInfo& info = kept.info();
    const diagnosis::Trust trust = diagnosis::read_trust(reader, info);

    std::vector<classification::Recording> recordings;
    if (sources.description.empty()) {
      stage.note_input("recording", sources.lone.file);
      recordings.push_back(classification::read_lone_file(sources.lone, info));
    } else {
      stage.note_input("description", sources.description);
      recordings = classification::read_described(
          sources.description, sources.data_dir, sources.records, info,
          [&](const signal::SourceFile& recording) {
            stage.note_read(sources.data_dir / recording.name);
            stage.note_input("recording", recording.name, recording.sha256);
          });
    }
    stage.require_free({output, csv, picture});
    std::vector<classification::Verdict> verdicts;
    cli::Progress progress("classify", "recordings", recordings.size());
    for (classification::Recording& recording : recordings) {
      verdicts.push_back(
          classification::judge(std::move(recording), kept, step == 0 ? kept.length() : step));
      progress.update(verdicts.size());
    }

    std::vector<text::File> texts;
    if (!csv.empty()) texts.push_back({csv, classification::csv_of(verdicts, info)});
    if (!picture.empty()) {
      texts.push_back({picture, classification::picture_of(verdicts, info, kept.length())});
    }
    text::save_all(texts);
    if (!output.empty()) {
      artefact::Writer writer("classification");
      classification::write(writer, verdicts, kept, reader.digest());
      stage.save(writer, output);
    }
    std::cout << classification::table_of(verdicts, info) << classification::origin_of(kept, trust);
  });
}

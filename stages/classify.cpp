// Applies a kept classifier to recordings.

#include <iostream>
#include <optional>
#include <vector>

#include "classification/fitted.hpp"
#include "classification/picture.hpp"
#include "classification/record.hpp"
#include "classification/recording_page.hpp"
#include "classification/sources.hpp"
#include "classification/texts.hpp"
#include "classification/verdict.hpp"
#include "cli/checks.hpp"
#include "cli/progress.hpp"
#include "cli/stage.hpp"
#include "diagnosis/trust.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

void require_classifier(const artefact::Reader& reader) {
  if (reader.kind() == "classifier") return;
  throw Error(
      Exit::bad_input,
      reader.path().string() + ": is an artefact of kind '" + reader.kind() +
          "', not 'classifier' (of diagnose --keep-classifier) or 'any-bearing' (of teach)");
}

void require_one_for_page(const std::vector<classification::Recording>& recordings) {
  if (recordings.size() == 1) return;
  throw Error(Exit::usage, "--page: shows one recording, not " + std::to_string(recordings.size()) +
                               "; choose one by --record, such as --record " +
                               recordings.front().name);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "classify",
      "Predicts the fault in recordings with a classifier that `diagnose --keep-classifier` "
      "stored: class and calibrated probability of each window and of the whole recording, or "
      "\"unknown\" if it differs from all trained classes. With the network for all machines that "
      "`teach` made, --healthy names healthy records of the machine; no training is needed. The "
      "picture adds the evidence: the envelope spectrum with the fault lines of the bearing. The "
      "page of one recording explains the verdict and has cursors for harmonics and side bands.",
      "classify --classifier classifier.h5 --recording bearing7.csv --variable 1 "
      "--sample-rate-hz 25600 --speed-rpm 1500 --picture bearing7.svg");
  fs::path classifier_file;
  classification::Sources sources;
  fs::path output;
  fs::path csv;
  fs::path picture;
  fs::path page;
  std::size_t step = 0;
  stage.input_file(
      "--classifier", classifier_file,
      "trained classifier, classifier.h5 of diagnose --keep-classifier; or a network for all "
      "machines, any-bearing.h5 of teach");
  bind(stage, sources);
  stage.options()
      .add("--step", step,
           "samples between the starts of successive windows, at the sample rate of the "
           "classifier; 0: the window length")
      .check(cli::whole_number(0, 1'000'000'000));
  stage.output_file("--output", output, "predictions for all windows (HDF5)").required(false);
  stage.output_file("--csv", csv, "predictions for all windows (CSV)").required(false);
  stage.output_file("--picture", picture, "predictions over time and envelope spectra (SVG)")
      .required(false);
  stage
      .output_file("--page", page,
                   "verdict, evidence and spectra of one recording, with cursors (HTML)")
      .required(false);

  return stage.run(argc, argv, [&] {
    require_one(sources);
    const artefact::Reader reader = stage.open("classifier", classifier_file, "");
    const bool for_all_machines = reader.kind() == "any-bearing";
    if (!for_all_machines) {
      require_classifier(reader);
      require_no_healthy_records(sources);
    }
    diagnosis::KeptClassifier kept = for_all_machines
                                         ? classification::fit_to_machine(stage, reader, sources)
                                         : diagnosis::KeptClassifier(reader);
    const signal::DatasetInfo& info = kept.info();
    std::optional<diagnosis::Trust> trust;
    if (!for_all_machines) trust = diagnosis::read_trust(reader, info);

    std::vector<classification::Recording> recordings =
        classification::read(stage, sources, kept.classifier(), info);
    if (!page.empty()) require_one_for_page(recordings);
    stage.require_free({output, csv, picture, page});
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
    const std::string origin = classification::origin_of(kept, trust);
    if (!page.empty()) {
      texts.push_back({page, classification::recording_page(
                                 verdicts.front(), {.info = info,
                                                    .is_calibrated = kept.calibration().windows > 0,
                                                    .words = origin})});
    }
    text::save_all(texts);
    if (!output.empty()) {
      artefact::Writer writer("classification");
      classification::write(writer, verdicts, kept, reader.digest());
      stage.save(writer, output);
    }
    std::cout << classification::table_of(verdicts, info) << classification::speeds_of(verdicts)
              << origin;
  });
}

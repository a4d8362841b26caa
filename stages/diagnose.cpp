// Trains the classifier on known and generated windows, and tests it on the test windows.

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/progress.hpp"
#include "cli/run_options.hpp"
#include "cli/stage.hpp"
#include "diagnosis/catalogue.hpp"
#include "diagnosis/diagnosis.hpp"
#include "seam/libtorch.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "diagnose",
      "Trains the classifier WDCNN on the healthy windows B, the known fault windows C and, of "
      "each fault class, the first windows of E that the ratio asks for; then tries it on the test "
      "windows A. Every window, or spectrum of one, is freed of its mean and scaled to unit "
      "standard deviation. The model of the last epoch is used, never one chosen on A. The "
      "classifier nearest is not trained: it names the class of the nearest of these windows. "
      "envelope-rule and exclusion-rule compare fault lines, and spectra, with those of B alone. "
      "symptom-net is trained on what both measure, with settings of its own.",
      "diagnose --test A.h5 --normal B.h5 --known C.h5 --generated E.h5 --ratio 10to1 "
      "--seed 0 --output diagnosis.h5");
  diagnosis::WdcnnOptions options;
  std::string ratio_name;
  std::string classifier_name = scoring::paper_classifier;
  cli::RunOptions run;
  bool reproducible = false;
  bool keep_features = false;
  diagnosis::InputFiles files;
  fs::path output;
  fs::path classifier_file;
  bind(stage, files);
  stage.output_file("--output", output, "diagnosis.h5, predictions and training curves")
      .required(false);
  stage
      .output_file(
          "--keep-classifier", classifier_file,
          "classifier.h5: the trained classifier itself, for classify and monitor. It is "
          "trained five times more, to learn how sure it may be of windows it has not seen")
      .required(false);
  stage.file_flag("--keep-features", keep_features,
                  "also store what the classifier makes of the test windows: its last hidden layer "
                  "and its output layer");
  stage.options()
      .add("--ratio", ratio_name,
           "normal to fault windows, and in brackets the generated ones of each fault class: " +
               scoring::list_of_ratios())
      .required();
  stage.options().add("--classifier", classifier_name, diagnosis::list_of_classifiers());
  stage.record_unless_default("--classifier");
  bind(stage.options(), run);
  stage.options().flag("--reproducible", reproducible,
                       "leave out the attribute train_windows_per_second, the one thing here that "
                       "differs from run to run, so that the bytes are the same each time");
  bind(stage.options(), options);

  return stage.run(argc, argv, [&] {
    const diagnosis::Classifier& classifier = diagnosis::the_classifier(classifier_name);
    if (output.empty() && classifier_file.empty()) {
      throw Error(Exit::usage, "--output is required, or --keep-classifier");
    }
    const scoring::Ratio& ratio = scoring::find_ratio(ratio_name);
    const diagnosis::MakeWdcnnBackend make_backend =
        classifier.represent != nullptr ? seam::wdcnn_backend(run.compute, argv) : nullptr;
    diagnosis::Diagnosis diagnosis({.classifier = classifier,
                                    .ratio = ratio,
                                    .seed = run.seed,
                                    .options = options,
                                    .make_backend = make_backend,
                                    .keep_features = keep_features},
                                   diagnosis::read_inputs(stage, files), files.known.string());
    cli::Progress progress("diagnose", "epochs", diagnosis.epochs(!classifier_file.empty()));
    std::size_t done = 0;
    const auto epoch_done = [&](std::int64_t /*of_one*/, double loss) {
      progress.update(++done, fmt::format("loss {:.3g}", loss));
    };
    diagnosis.learn(epoch_done);
    if (!output.empty()) {
      artefact::Writer writer("diagnosis");
      const std::string summary = diagnosis.write(writer, reproducible);
      stage.save(writer, output);
      std::cout << summary << ": " << output.string() << '\n';
    }
    if (!classifier_file.empty()) {
      artefact::Writer writer("classifier");
      const std::string summary = diagnosis.write_classifier(writer, epoch_done);
      stage.save(writer, classifier_file);
      std::cout << fmt::format("kept {}: {} ({:.1f} MB)\n", summary, classifier_file.string(),
                               static_cast<double>(fs::file_size(classifier_file)) / 1e6);
    }
  });
}

// Trains the classifier on known and generated windows, and tests it on the test windows.

#include <spdlog/fmt/fmt.h>

#include <iostream>
#include <optional>

#include "cli/progress.hpp"
#include "cli/run_options.hpp"
#include "cli/stage.hpp"
#include "diagnosis/catalogue.hpp"
#include "diagnosis/diagnosis.hpp"
#include "seam/libtorch.hpp"
#include "symptoms/measures.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "diagnose",
      "Trains a classifier on the healthy windows B, the known fault windows C and the first "
      "generated windows E of each fault class (the number depends on --ratio). Then tests it on "
      "the test windows A. Each window, or its spectrum, has its mean removed and is scaled to "
      "unit standard deviation. WDCNN keeps the model of the last epoch; the test windows never "
      "select a model. nearest is not trained: it predicts the class of the nearest of these "
      "windows. envelope-rule and exclusion-rule compare fault lines and spectra with the "
      "healthy windows only. any-bearing does the same with a network that teach made for all "
      "machines. symptom-net and prototypes are small networks with settings of their "
      "own. dann and cdan also see unlabelled windows of the tested condition: those of D and B.",
      "diagnose --test A.h5 --normal B.h5 --known C.h5 --generated E.h5 --ratio 10to1 "
      "--seed 0 --output diagnosis.h5");
  diagnosis::LearningSettings settings;
  std::string ratio_name;
  std::string classifier_name = scoring::paper_classifier;
  cli::RunOptions run;
  bool reproducible = false;
  bool keep_features = false;
  diagnosis::InputFiles files;
  fs::path network_file;
  fs::path output;
  fs::path classifier_file;
  bind(stage, files);
  stage
      .input_file("--network", network_file,
                  "network for all machines, any-bearing.h5 of teach; only for any-bearing")
      .required(false);
  stage.output_file("--output", output, "predictions and training curves, diagnosis.h5")
      .required(false);
  stage
      .output_file(
          "--keep-classifier", classifier_file,
          "trained classifier for classify and monitor, classifier.h5; training is repeated "
          "five times to calibrate its probabilities")
      .required(false);
  stage.file_flag("--keep-features", keep_features,
                  "also store the outputs of the last hidden layer and of the output layer for "
                  "the test windows");
  stage.options()
      .add("--ratio", ratio_name,
           "ratio of healthy to fault windows (in brackets: generated windows of each fault "
           "class): " +
               scoring::list_of_ratios())
      .required();
  stage.options().add("--classifier", classifier_name, diagnosis::list_of_classifiers());
  stage.record_unless_default("--classifier");
  bind(stage.options(), run);
  stage.options().flag("--reproducible", reproducible,
                       "leave out the attribute train_windows_per_second, so that repeated runs "
                       "give the same bytes");
  stage.options()
      .add("--prewhitening", settings.prewhitening,
           "power of a spectrum's own amplitude that divides it, from 0 to 1; for the rules (0.5) "
           "and symptom-net (0)")
      .check(cli::within(symptoms::possible_prewhitening));
  stage.record_unless_default("--prewhitening");
  bind(stage.options(), settings.wdcnn);

  return stage.run(argc, argv, [&] {
    const diagnosis::Classifier& classifier = diagnosis::the_classifier(classifier_name);
    if (output.empty() && classifier_file.empty()) {
      throw Error(Exit::usage, "give --output or --keep-classifier (see diagnose --help)");
    }
    const scoring::Ratio& ratio = scoring::find_ratio(ratio_name);
    if (classifier.adapts() && needs_libtorch(run.compute)) {
      throw Error(Exit::usage, fmt::format("--backend, --device: {} is computed on one core only; "
                                           "leave these options out",
                                           classifier.name));
    }
    if (classifier.represent != nullptr) {
      settings.make_backend = seam::wdcnn_backend(run.compute, argv);
    }
    std::optional<artefact::Reader> network;
    if (!network_file.empty()) {
      settings.network = &network.emplace(stage.open("network", network_file, "any-bearing"));
    }
    diagnosis::Diagnosis diagnosis({.classifier = classifier,
                                    .ratio = ratio,
                                    .seed = run.seed,
                                    .settings = settings,
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

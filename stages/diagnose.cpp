// Trains the classifier on known and generated windows, and tests it on the test windows.

#include <spdlog/fmt/fmt.h>

#include <iostream>
#include <optional>

#include "cli/progress.hpp"
#include "cli/run_options.hpp"
#include "cli/stage.hpp"
#include "diagnosis/classify.hpp"
#include "diagnosis/inputs.hpp"
#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/training_set.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/ratios.hpp"
#include "seam/libtorch.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

scoring::DiagnosisRecord make_record(const diagnosis::Inputs& inputs, const std::string& classifier,
                                     const scoring::Ratio& ratio, std::int64_t seed,
                                     const diagnosis::WdcnnResult& result, bool keep_features) {
  scoring::DiagnosisRecord record;
  record.info = inputs.test.info;
  record.method = inputs.method;
  record.classifier = classifier;
  record.ratio = ratio.name;
  record.generated_per_class = ratio.generated_per_class;
  const auto fault_classes = static_cast<std::int64_t>(record.info.classes.size()) - 1;
  record.true_ratio = scoring::true_ratio(
      static_cast<std::int64_t>(inputs.normal.size()),
      static_cast<std::int64_t>(inputs.known.size()) / fault_classes, ratio.generated_per_class);
  record.any_known = inputs.known.size() > 0;
  record.seed = seed;
  record.protocol = inputs.protocol;
  record.labels = inputs.test.labels;
  record.predictions = result.predictions;
  record.scores = result.outputs.scores;
  record.loss = result.loss;
  record.train_accuracy = result.train_accuracy;
  if (keep_features) {
    record.features = {.hidden = result.outputs.hidden, .output = result.outputs.logits};
  }
  return record;
}

/// What a classifier made of how many windows.
std::string basis_of(const diagnosis::Classifier& classifier, const diagnosis::Inputs& inputs,
                     std::size_t training_windows) {
  if (classifier.rule) return fmt::format("against {} healthy ones", inputs.normal.size());
  return fmt::format("{} {}", classifier.trains() ? "after training on" : "by the nearest of",
                     training_windows);
}

/// What was done, and how well: the last line of the stage.
std::string said_of(const scoring::DiagnosisRecord& record, const std::string& basis,
                    std::optional<double> rate) {
  const std::string by =
      record.classifier == scoring::paper_classifier ? "" : fmt::format(", {}", record.classifier);
  return fmt::format("diagnosed {} windows {} ({} {}{}, seed {}): accuracy {:.2f} %{}",
                     record.labels.size(), basis, record.method, record.ratio, by, record.seed,
                     100 * record.accuracy(),
                     rate ? fmt::format(", {:.0f} windows/s in training", *rate) : "");
}

diagnosis::MakeWdcnnBackend choose_backend(const Compute& compute, char** argv) {
  if (!needs_libtorch(compute)) return diagnosis::make_one_core_backend;
  seam::continue_with_libtorch(argv);
  return seam::back_ends()->wdcnn(compute.device);
}

}  // namespace

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
  fs::path test_file;
  fs::path normal_file;
  fs::path known_file;
  fs::path generated_file;
  fs::path output;
  stage.input_file("--test", test_file, "A.h5 made by split");
  stage.input_file("--normal", normal_file, "B.h5 made by split");
  stage.input_file("--known", known_file, "C.h5 made by split");
  stage.input_file("--generated", generated_file, "E.h5 made by generate; not with 100to1")
      .required(false);
  stage.output_file("--output", output, "diagnosis.h5, predictions and training curves");
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
    if (keep_features && !classifier.trains()) {
      throw Error(Exit::usage, fmt::format("--keep-features: {} has no layers; leave it out, or "
                                           "choose another --classifier",
                                           classifier_name));
    }
    if (classifier.rule && !generated_file.empty()) {
      throw Error(Exit::usage, fmt::format("--generated: {} is a rule, which learns from healthy "
                                           "windows alone; leave the option out, and choose "
                                           "--ratio {}",
                                           classifier_name, scoring::all_ratios().front().name));
    }
    const diagnosis::MakeWdcnnBackend make_backend =
        classifier.represent != nullptr ? choose_backend(run.compute, argv) : nullptr;
    const scoring::Ratio& ratio = scoring::find_ratio(ratio_name);
    std::optional<artefact::Reader> generated;
    const artefact::Reader test = stage.open("test", test_file, "windows");
    const artefact::Reader normal = stage.open("normal", normal_file, "windows");
    const artefact::Reader known = stage.open("known", known_file, "windows");
    if (!generated_file.empty()) {
      generated.emplace(stage.open("generated", generated_file, "windows"));
    }
    const diagnosis::Inputs inputs =
        diagnosis::read_inputs(test, normal, known, generated ? &*generated : nullptr);
    const signal::WindowSet training = diagnosis::compose_training_set(
        inputs.normal, inputs.known, inputs.generated ? &*inputs.generated : nullptr,
        ratio.generated_per_class);
    diagnosis::require_faults(training, classifier, known_file.string());
    diagnosis::require_fitting_test_set(inputs.test, training);

    const Stream stream(
        fmt::format("{}/seed{}/diagnose/{}", training.info.name, run.seed, ratio.name));
    const std::int64_t epochs = diagnosis::epochs_of(classifier, options);
    cli::Progress progress("diagnose", "epochs", static_cast<std::size_t>(epochs));
    const diagnosis::WdcnnResult result = diagnosis::classify(
        classifier, inputs.normal, training, inputs.test, options, stream, make_backend,
        [&](std::int64_t done, double loss) {
          progress.update(static_cast<std::size_t>(done), fmt::format("loss {:.3g}", loss));
        });

    scoring::DiagnosisRecord record =
        make_record(inputs, classifier_name, ratio, run.seed, result, keep_features);
    std::optional<double> rate;
    if (classifier.trains()) {
      rate = static_cast<double>(epochs) * static_cast<double>(training.size()) /
             result.training_seconds;
    }
    if (!reproducible) record.train_windows_per_second = rate;
    artefact::Writer writer("diagnosis");
    scoring::write(writer, record);
    stage.save(writer, output);
    std::cout << fmt::format("{}: {}\n",
                             said_of(record, basis_of(classifier, inputs, training.size()), rate),
                             output.string());
  });
}

// Trains the classifier on known and generated windows, and tests it on the test windows.

#include <spdlog/fmt/fmt.h>

#include <iostream>
#include <optional>

#include "cli/progress.hpp"
#include "cli/run_options.hpp"
#include "cli/stage.hpp"
#include "diagnosis/inputs.hpp"
#include "diagnosis/keep.hpp"
#include "diagnosis/learn.hpp"
#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/training_set.hpp"
#include "diagnosis/trust.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/ratios.hpp"
#include "seam/libtorch.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

scoring::DiagnosisRecord make_record(const diagnosis::Inputs& inputs, const std::string& classifier,
                                     const scoring::Ratio& ratio, std::int64_t seed,
                                     const diagnosis::Training& training,
                                     diagnosis::WdcnnOutputs outputs, bool keep_features) {
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
  record.predictions = diagnosis::most_likely(outputs.scores, record.info.classes.size());
  record.scores = std::move(outputs.scores);
  record.loss = training.loss;
  record.train_accuracy = training.train_accuracy;
  if (keep_features) {
    record.features = {.hidden = std::move(outputs.hidden), .output = std::move(outputs.logits)};
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

/// Shows how far the epochs of several trainings are, one after the other.
class Epochs {
 public:
  explicit Epochs(std::int64_t in_all)
      : progress_("diagnose", "epochs", static_cast<std::size_t>(in_all)) {}

  diagnosis::EpochDone counter() {
    return [this](std::int64_t /*done*/, double loss) {
      progress_.update(++done_, fmt::format("loss {:.3g}", loss));
    };
  }

 private:
  cli::Progress progress_;
  std::size_t done_ = 0;
};

/// What is wrong with options that do not go with a classifier.
void require_fitting_options(const diagnosis::Classifier& classifier, bool keep_features,
                             const fs::path& generated_file) {
  if (keep_features && !classifier.trains()) {
    throw Error(Exit::usage, fmt::format("--keep-features: {} has no layers; leave it out, or "
                                         "choose another --classifier",
                                         classifier.name));
  }
  if (classifier.rule && !generated_file.empty()) {
    throw Error(Exit::usage, fmt::format("--generated: {} is a rule, which learns from healthy "
                                         "windows alone; leave the option out, and choose "
                                         "--ratio {}",
                                         classifier.name, scoring::all_ratios().front().name));
  }
}

/// Writes the classifier, and what its answers on the test windows are worth.
void save_classifier(const cli::Stage& stage, diagnosis::KeptClassifier& kept,
                     const signal::WindowSet& test, const fs::path& file) {
  const diagnosis::Trust trust = diagnosis::trust_in(kept, test);
  artefact::Writer writer("classifier");
  kept.write(writer);
  diagnosis::write(writer, trust);
  stage.save(writer, file);
  std::cout << fmt::format(
      "kept {} with temperature {:.2f} by {} windows left out: calibration error {:.1f} % of the "
      "test windows, {:.1f} % of them called unknown: {} ({:.1f} MB)\n",
      kept.classifier().name, kept.calibration().temperature, kept.calibration().windows,
      100 * trust.calibration_error, 100 * trust.called_unknown, file.string(),
      static_cast<double>(fs::file_size(file)) / 1e6);
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
  fs::path classifier_file;
  stage.input_file("--test", test_file, "A.h5 made by split");
  stage.input_file("--normal", normal_file, "B.h5 made by split");
  stage.input_file("--known", known_file, "C.h5 made by split");
  stage.input_file("--generated", generated_file, "E.h5 made by generate; not with 100to1")
      .required(false);
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
    require_fitting_options(classifier, keep_features, generated_file);
    if (output.empty() && classifier_file.empty()) {
      throw Error(Exit::usage, "--output is required, or --keep-classifier");
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
    const diagnosis::Lessons lessons{.normal = inputs.normal,
                                     .known = inputs.known,
                                     .generated = inputs.generated ? &*inputs.generated : nullptr,
                                     .generated_per_class = ratio.generated_per_class};
    const std::int64_t epochs = diagnosis::epochs_of(classifier, options);
    Epochs shown(epochs * (classifier_file.empty()
                               ? 1
                               : 1 + diagnosis::trainings_to_keep(training, lessons)));
    diagnosis::Learned learned = diagnosis::learn(classifier, inputs.normal, training, options,
                                                  stream, make_backend, shown.counter());

    if (!output.empty()) {
      scoring::DiagnosisRecord record =
          make_record(inputs, classifier_name, ratio, run.seed, learned.training,
                      learned.trained->outputs(inputs.test, "--test"), keep_features);
      std::optional<double> rate;
      if (classifier.trains()) {
        rate = static_cast<double>(epochs) * static_cast<double>(training.size()) /
               learned.training.seconds;
      }
      if (!reproducible) record.train_windows_per_second = rate;
      artefact::Writer writer("diagnosis");
      scoring::write(writer, record);
      stage.save(writer, output);
      std::cout << fmt::format("{}: {}\n",
                               said_of(record, basis_of(classifier, inputs, training.size()), rate),
                               output.string());
    }
    if (!classifier_file.empty()) {
      diagnosis::KeptClassifier kept =
          diagnosis::keep(classifier, std::move(learned.trained), training, lessons,
                          {.options = options,
                           .stream = stream,
                           .make_backend = make_backend,
                           .epoch_done = shown.counter()},
                          {.method = inputs.method,
                           .ratio = ratio.name,
                           .generated_per_class = ratio.generated_per_class,
                           .seed = run.seed,
                           .protocol = inputs.protocol});
      save_classifier(stage, kept, inputs.test, classifier_file);
    }
  });
}

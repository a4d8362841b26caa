#include "diagnosis/diagnosis.hpp"

#include <spdlog/fmt/fmt.h>

#include <utility>

#include "base/error.hpp"
#include "diagnosis/keep.hpp"
#include "diagnosis/learn.hpp"
#include "diagnosis/training_set.hpp"
#include "diagnosis/trust.hpp"

namespace piae::diagnosis {

namespace {

void require_fitting_options(const Task& task, const Inputs& inputs) {
  const Classifier& classifier = task.classifier;
  if (task.keep_features && !classifier.trains()) {
    throw Error(Exit::usage, fmt::format("--keep-features: {} does not have layers; leave the "
                                         "option out, or choose another --classifier",
                                         classifier.name));
  }
  if (task.settings.prewhitening && !classifier.prewhitening) {
    throw Error(Exit::usage, fmt::format("--prewhitening: {} does not take one; leave the "
                                         "option out, or choose another --classifier",
                                         classifier.name));
  }
  if (classifier.adapts() && !inputs.unlabelled) {
    throw Error(Exit::usage,
                fmt::format("--classifier {} needs --unlabelled, D.h5 of split", classifier.name));
  }
  if (!classifier.adapts() && inputs.unlabelled) {
    throw Error(Exit::usage,
                fmt::format("--unlabelled: {} must not see D; leave the option out, or "
                            "choose another --classifier",
                            classifier.name));
  }
  if (classifier.rule && inputs.generated) {
    throw Error(Exit::usage, fmt::format("--generated: {} is a rule and uses healthy windows "
                                         "only; leave the option out and give --ratio {}",
                                         classifier.name, scoring::all_ratios().front().name));
  }
}

const signal::WindowSet* generated_of(const Inputs& inputs) {
  return inputs.generated ? &*inputs.generated : nullptr;
}

signal::WindowSet training_set_of(const Task& task, const Inputs& inputs) {
  require_fitting_options(task, inputs);
  return compose_training_set(inputs.normal, inputs.known, generated_of(inputs),
                              task.ratio.generated_per_class);
}

}  // namespace

Diagnosis::Diagnosis(Task task, Inputs inputs, const std::string& known_file)
    : task_(std::move(task)),
      inputs_(std::move(inputs)),
      training_set_(training_set_of(task_, inputs_)),
      stream_(fmt::format("{}/seed{}/diagnose/{}", training_set_.info.name, task_.seed,
                          task_.ratio.name)) {
  require_faults(training_set_, task_.classifier, known_file);
  require_fitting_test_set(inputs_.test, training_set_);
}

Lessons Diagnosis::lessons() const {
  return {.normal = inputs_.normal,
          .known = inputs_.known,
          .generated = generated_of(inputs_),
          .generated_per_class = task_.ratio.generated_per_class};
}

LearningSettings Diagnosis::settings() const {
  LearningSettings settings = task_.settings;
  if (inputs_.unlabelled) settings.unlabelled = &*inputs_.unlabelled;
  return settings;
}

std::size_t Diagnosis::epochs(bool is_kept) const {
  const std::int64_t trainings = 1 + (is_kept ? trainings_to_keep(training_set_, lessons()) : 0);
  return static_cast<std::size_t>(trainings * epochs_of(task_.classifier, task_.settings.wdcnn));
}

void Diagnosis::learn(const EpochDone& epoch_done) {
  learned_ = diagnosis::learn(task_.classifier, inputs_.normal, training_set_, settings(), stream_,
                              epoch_done);
}

std::optional<double> Diagnosis::windows_per_second() const {
  if (!task_.classifier.trains()) return std::nullopt;
  return static_cast<double>(epochs(false)) * static_cast<double>(training_set_.size()) /
         learned_.training.seconds;
}

scoring::DiagnosisRecord Diagnosis::record() {
  Outputs outputs = learned_.trained->outputs(inputs_.test, "--test");
  scoring::DiagnosisRecord record;
  record.info = inputs_.test.info;
  record.method = inputs_.method;
  record.classifier = task_.classifier.name;
  record.ratio = task_.ratio.name;
  record.generated_per_class = task_.ratio.generated_per_class;
  const auto fault_classes = static_cast<std::int64_t>(record.info.classes.size()) - 1;
  record.true_ratio = scoring::true_ratio(
      static_cast<std::int64_t>(inputs_.normal.size()),
      static_cast<std::int64_t>(inputs_.known.size()) / fault_classes, record.generated_per_class);
  record.any_known = inputs_.known.size() > 0;
  record.seed = task_.seed;
  record.protocol = inputs_.protocol;
  record.labels = inputs_.test.labels;
  record.predictions = most_likely(outputs.scores, record.info.classes.size());
  record.scores = std::move(outputs.scores);
  record.loss = learned_.training.loss;
  record.train_accuracy = learned_.training.train_accuracy;
  record.train_windows_per_second = windows_per_second();
  if (task_.keep_features) {
    record.features = {.hidden = std::move(outputs.hidden), .output = std::move(outputs.logits)};
  }
  return record;
}

std::string Diagnosis::summary_of(const scoring::DiagnosisRecord& record) const {
  const Classifier& classifier = task_.classifier;
  const std::string basis =
      classifier.rule
          ? fmt::format("by comparison with {} healthy windows", inputs_.normal.size())
          : fmt::format("{} {}", classifier.trains() ? "after training on" : "by the nearest of",
                        training_set_.size());
  const std::string by =
      record.classifier == scoring::paper_classifier ? "" : fmt::format(", {}", record.classifier);
  const auto rate = windows_per_second();
  return fmt::format("diagnosed {} windows {} ({} {}{}, seed {}): accuracy {:.2f} %{}",
                     record.labels.size(), basis, record.method, record.ratio, by, record.seed,
                     100 * record.accuracy(),
                     rate ? fmt::format(", {:.0f} windows/s in training", *rate) : "");
}

std::string Diagnosis::write(artefact::Writer& writer, bool reproducible) {
  scoring::DiagnosisRecord of_test = record();
  if (reproducible) of_test.train_windows_per_second.reset();
  scoring::write(writer, of_test);
  return summary_of(of_test);
}

std::string Diagnosis::write_classifier(artefact::Writer& writer, const EpochDone& epoch_done) {
  KeptClassifier kept = keep(epoch_done);
  const Trust trust = trust_in(kept, inputs_.test);
  kept.write(writer);
  diagnosis::write(writer, trust);
  return diagnosis::summary_of(kept, trust);
}

KeptClassifier Diagnosis::keep(const EpochDone& epoch_done) {
  const LearningSettings own = settings();
  return diagnosis::keep(task_.classifier, std::move(learned_.trained), training_set_, lessons(),
                         {.settings = own, .stream = stream_, .epoch_done = epoch_done},
                         {.method = inputs_.method,
                          .ratio = task_.ratio.name,
                          .generated_per_class = task_.ratio.generated_per_class,
                          .seed = task_.seed,
                          .protocol = inputs_.protocol});
}

}  // namespace piae::diagnosis

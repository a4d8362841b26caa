// Replaces the steps of a grid by an instant stand-in: writes their files, each of its kind and
// small, and their logs. scale.sh measures make, status, tables, figures and report on them. The
// plan determines the steps from the variables in the environment, as for `plan`.
// usage: GOALS=cells RUN=... DATASETS=... SEEDS=... fill_run      in the project's folder

#include <spdlog/fmt/fmt.h>

#include <filesystem>
#include <iostream>
#include <unordered_map>
#include <vector>

#include "artefact/writer.hpp"
#include "base/error.hpp"
#include "base/random.hpp"
#include "cli/stage.hpp"
#include "plan/experiment.hpp"
#include "plan/plan.hpp"
#include "plan/request_options.hpp"
#include "run/layout.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/quality_record.hpp"
#include "scoring/ratios.hpp"
#include "support/stored_tested_windows.hpp"
#include "support/three_classes.hpp"
#include "text/file.hpp"
#include "twin/curves.hpp"

/// Replaces the system's fsync: measured files need not survive a power cut, and a hundred thousand
/// of them would wait half an hour for the disk.
extern "C" int fsync(int /*descriptor*/) { return 0; }

namespace piae {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t windows_per_class = 20;

/// Files made so far, which later steps need as inputs.
class Filled : public plan::Disk {
 public:
  void read_ahead(const std::vector<std::string>& /*files*/) override {}
  const plan::File* find(const std::string& file) override {
    const auto found = files_.find(file);
    return found == files_.end() ? nullptr : &found->second;
  }
  const artefact::DoneStep* done(const std::string& /*step*/) override { return nullptr; }
  std::vector<std::string> files_below(const std::string& /*folder*/) override { return {}; }
  std::string text_of(const std::string& /*file*/) override { return {}; }

  void add(const std::string& file, const artefact::Written& written,
           const artefact::Provenance& provenance) {
    files_[file] = {.digest = artefact::short_digest(written.digest),
                    .made = artefact::made_by(provenance),
                    .belongs_in = written.belongs_in};
  }

 private:
  std::unordered_map<std::string, plan::File> files_;
};

/// A step, and the provenance that its files record.
struct Task {
  const plan::Step& step;
  artefact::Provenance provenance;
  Filled& filled;

  [[nodiscard]] const plan::Place& place() const { return step.place; }
  [[nodiscard]] std::int64_t seed() const { return step.place.seed.value_or(0); }
};

std::vector<Label> labels_of_windows() {
  std::vector<Label> labels;
  for (const Label label : three_classes().labels()) {
    labels.insert(labels.end(), windows_per_class, label);
  }
  return labels;
}

void save(artefact::Writer& writer, const Task& task, const std::string& file) {
  task.filled.add(file, writer.save(file, task.provenance), task.provenance);
}

scoring::DiagnosisRecord diagnosis_of(const Task& task) {
  const plan::Place& place = task.place();
  const scoring::Ratio& ratio = scoring::find_ratio(place.ratio);
  scoring::DiagnosisRecord record;
  record.info = three_classes(place.dataset);
  record.method = place.method;
  record.classifier = place.classifier;
  record.ratio = place.ratio;
  record.generated_per_class = ratio.generated_per_class;
  record.true_ratio = 500.0 / (5.0 + static_cast<double>(ratio.generated_per_class));
  record.seed = task.seed();
  record.labels = labels_of_windows();
  // The accuracy depends on the method, the ratio and the seed.
  Stream of_method(place.method);
  const double share = of_method.uniform(0.5, 0.9);
  Stream random(fmt::format("{}/{}/{}/{}", place.dataset, task.seed(), place.method, place.ratio));
  for (const Label label : record.labels) {
    const bool right = random.uniform(0, 1) < share;
    record.predictions.push_back(right ? label : (label + 1) % 3);
    for (const Label each : {0, 1, 2}) {
      record.scores.push_back(each == record.predictions.back() ? 0.8F : 0.1F);
    }
  }
  record.loss = {1};
  record.train_accuracy = {1};
  if (task.step.log == "features") {
    record.features = {.hidden = record.scores, .output = record.scores};
  }
  return record;
}

scoring::QualityRecord quality_of(const Task& task) {
  const plan::Place& place = task.place();
  Stream random(fmt::format("{}/{}/{}", place.dataset, task.seed(), place.method));
  scoring::QualityRecord record;
  record.info = three_classes(place.dataset);
  record.method = place.method;
  record.seed = task.seed();
  for (const Label label : record.info.fault_labels()) {
    const double value = random.uniform(0.1, 1);
    record.classes.push_back({label, 9, value, 2 * value, value, value, value, value, value});
  }
  return record;
}

void save_model(const Task& task) {
  const std::vector<double> losses{0.3, 0.2, 0.1};
  twin::Curves curves;
  for (auto values : {&twin::Curves::reconstruction, &twin::Curves::differential,
                      &twin::Curves::twin, &twin::Curves::total, &twin::Curves::alpha,
                      &twin::Curves::beta, &twin::Curves::gamma, &twin::Curves::learning_rate}) {
    curves.*values = losses;
  }
  artefact::Writer writer("model");
  writer.attribute("/", "method", task.place().method);
  writer.attribute("/", "seed", task.seed());
  curves.write(writer);
  save(writer, task, task.step.outputs.front());
}

/// Writes a file without windows, for outputs of which only the existence matters here.
void save_empty(const std::string& kind, const Task& task, const std::string& file) {
  artefact::Writer writer(kind);
  if (kind == "records") writer.group("/records");
  if (kind == "windows") writer.attribute("/", "role", fs::path(file).stem().string());
  save(writer, task, file);
}

void save_windows(const Task& task) {
  const plan::Place& place = task.place();
  const fs::path run = fs::path(task.step.folder).parent_path().parent_path();
  const run::Layout layout(run, place.dataset);
  const std::vector<Label> labels = labels_of_windows();
  const artefact::Written written = save_tested_windows(layout, place.dataset, task.seed(), labels,
                                                        one_record(labels.size()), task.provenance);
  for (const std::string& file : task.step.outputs) {
    if (file.ends_with("/A.h5")) {
      task.filled.add(file, written, task.provenance);
    } else {
      save_empty("windows", task, file);
    }
  }
}

template <class Record>
void save_record(const std::string& kind, const Record& record, const Task& task) {
  artefact::Writer writer(kind);
  scoring::write(writer, record);
  save(writer, task, task.step.outputs.front());
}

/// Writes the log that step.sh would leave. `count` steps have come before, one per second.
void save_log(const plan::Step& step, std::size_t count) {
  text::save_all(
      {{plan::log_of(step), fmt::format("build/bin/{0} --of {1}\n"
                                        "step: started at {2}.000000\n"
                                        "step: started\n"
                                        "{0} something: {1}\n"
                                        "step: used 0.70 s of processor time and 100 MB of memory\n"
                                        "step: exit 0 after 0.8 s\n",
                                        step.stage, step.folder, 1'700'000'000 + count)}});
}

void do_step(const Task& task) {
  const std::string& stage = task.step.stage;
  const std::string& file = task.step.outputs.front();
  if (stage == "simulate") save_empty("records", task, file);
  if (stage == "split") save_windows(task);
  if (stage == "train") save_model(task);
  if (stage == "generate") save_empty("windows", task, file);
  if (stage == "score") save_record("score", quality_of(task), task);
  if (stage == "diagnose") save_record("diagnosis", diagnosis_of(task), task);
}

void fill_run(const plan::Request& request) {
  Filled filled;
  const plan::Experiment experiment = plan::read_experiment("pipeline");
  plan::Plan plan(experiment, plan::choose(experiment, request), plan::Stretch::grid, filled);
  std::size_t count = 0;
  for (const plan::StepId id : plan.requested()) {
    const plan::Step& step = plan.graph().at(id);
    // A judge caches its findings, so each step needs its own.
    const artefact::Made made = plan::Judge(plan.graph(), filled).made_now(id).made;
    artefact::Provenance provenance{.program = step.stage, .options = *made.options, .inputs = {}};
    for (const artefact::MadeFrom& from : made.inputs) {
      provenance.inputs.push_back({from.role, from.role, from.digest});
    }
    do_step({step, std::move(provenance), filled});
    save_log(step, count++);
  }
}

}  // namespace
}  // namespace piae

int main(int argc, char** argv) {
  piae::cli::Stage stage("fill_run", "Writes what the steps of a grid would make.",
                         "GOALS=cells RUN=try DATASETS=cwru fill_run");
  piae::plan::RequestOptions requested;
  bind(stage.options(), requested);
  return stage.run(argc, argv, [&] { piae::fill_run(requested.request()); });
}

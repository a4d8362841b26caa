// Does what the steps of a grid would do, in no time: writes their files, each of its kind and
// small, and their logs. For scale.sh, which measures what make, status, tables, figures and report
// make of them. usage: make -n ... | awk -f jobs/steps.awk | fill_run      in the project's folder

#include <spdlog/fmt/fmt.h>

#include <filesystem>
#include <iostream>
#include <sstream>
#include <vector>

#include "artefact/writer.hpp"
#include "base/random.hpp"
#include "run/layout.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/quality_record.hpp"
#include "scoring/ratios.hpp"
#include "support/stored_tested_windows.hpp"
#include "support/three_classes.hpp"
#include "text/file.hpp"
#include "twin/curves.hpp"

/// In the place of the system's: what is measured for a minute need not outlive a power cut, and a
/// hundred thousand files would wait for the disk for half an hour.
extern "C" int fsync(int /*descriptor*/) { return 0; }

namespace piae {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t windows_per_class = 20;

/// results/RUN/DATASET/seedN/METHOD/RATIO/CLASSIFIER, as far as the step has it.
struct Place {
  fs::path run;
  std::string dataset;
  std::int64_t seed = 0;
  std::string method;
  std::string ratio;
  std::string classifier = scoring::paper_classifier;
};

Place place_of(const fs::path& folder) {
  std::vector<std::string> parts;
  for (const fs::path& part : folder) parts.push_back(part.string());
  Place place;
  place.run = fs::path(parts.at(0)) / parts.at(1);
  place.dataset = parts.at(2);
  if (parts.size() > 3) place.seed = std::stoll(parts[3].substr(std::string("seed").size()));
  if (parts.size() > 4) place.method = parts[4];
  if (parts.size() > 5) place.ratio = parts[5];
  if (parts.size() > 6) place.classifier = parts[6];
  return place;
}

std::vector<Label> labels_of_windows() {
  std::vector<Label> labels;
  for (const Label label : three_classes().labels()) {
    labels.insert(labels.end(), windows_per_class, label);
  }
  return labels;
}

void save(artefact::Writer& writer, const fs::path& file, const std::string& stage) {
  writer.save(file, {stage, "", {}});
}

scoring::DiagnosisRecord diagnosis_of(const Place& place) {
  const scoring::Ratio& ratio = scoring::find_ratio(place.ratio);
  scoring::DiagnosisRecord record;
  record.info = three_classes(place.dataset);
  record.method = place.method;
  record.classifier = place.classifier;
  record.ratio = place.ratio;
  record.generated_per_class = ratio.generated_per_class;
  record.true_ratio = 500.0 / (5.0 + static_cast<double>(ratio.generated_per_class));
  record.seed = place.seed;
  record.labels = labels_of_windows();
  // Some methods recognise more than others, and more at another ratio and seed.
  Stream of_method(place.method);
  const double share = of_method.uniform(0.5, 0.9);
  Stream random(fmt::format("{}/{}/{}/{}", place.dataset, place.seed, place.method, place.ratio));
  for (const Label label : record.labels) {
    const bool right = random.uniform(0, 1) < share;
    record.predictions.push_back(right ? label : (label + 1) % 3);
    for (const Label each : {0, 1, 2}) {
      record.scores.push_back(each == record.predictions.back() ? 0.8F : 0.1F);
    }
  }
  record.loss = {1};
  record.train_accuracy = {1};
  return record;
}

scoring::QualityRecord quality_of(const Place& place) {
  Stream random(fmt::format("{}/{}/{}", place.dataset, place.seed, place.method));
  scoring::QualityRecord record;
  record.info = three_classes(place.dataset);
  record.method = place.method;
  record.seed = place.seed;
  for (const Label label : record.info.fault_labels()) {
    const double value = random.uniform(0.1, 1);
    record.classes.push_back({label, 9, value, 2 * value, value, value, value, value, value});
  }
  return record;
}

void save_model(const Place& place, const fs::path& file) {
  const std::vector<double> losses{0.3, 0.2, 0.1};
  twin::Curves curves;
  for (auto values : {&twin::Curves::reconstruction, &twin::Curves::differential,
                      &twin::Curves::twin, &twin::Curves::total, &twin::Curves::alpha,
                      &twin::Curves::beta, &twin::Curves::gamma, &twin::Curves::learning_rate}) {
    curves.*values = losses;
  }
  artefact::Writer writer("model");
  writer.attribute("/", "method", place.method);
  writer.attribute("/", "seed", place.seed);
  curves.write(writer);
  save(writer, file, "train");
}

/// What is only there or not for make, and for those who read it holds no window.
void save_empty(const std::string& kind, const fs::path& file, const std::string& stage) {
  artefact::Writer writer(kind);
  save(writer, file, stage);
}

void save_windows(const Place& place) {
  const run::Layout layout(place.run, place.dataset);
  const std::vector<Label> labels = labels_of_windows();
  save_tested_windows(layout, place.dataset, place.seed, labels, one_record(labels.size()));
  for (const char* role : {"B", "C", "D"}) {
    save_empty("windows", layout.windows(role, place.seed), "split");
  }
}

template <class Record>
void save_record(const std::string& kind, const Record& record, const fs::path& file,
                 const std::string& stage) {
  artefact::Writer writer(kind);
  scoring::write(writer, record);
  save(writer, file, stage);
}

/// The log that step.sh would leave. `count` steps have come before, one a second.
void save_log(const fs::path& folder, const std::string& stage, std::size_t count) {
  text::save_all({{folder / (stage + ".log"),
                   fmt::format("build/bin/{0} --of {1}\n"
                               "step: begun at {2}.000000\n"
                               "step: started\n"
                               "{0} something: {1}\n"
                               "step: used 0.70 s of processor time and 100 MB of memory\n"
                               "step: exit 0 after 0.8 s\n",
                               stage, folder.string(), 1'700'000'000 + count)}});
}

void do_step(const fs::path& folder, const std::string& stage, const fs::path& file) {
  const Place place = place_of(folder);
  if (stage == "simulate") save_empty("records", file, stage);
  if (stage == "split") save_windows(place);
  if (stage == "train") save_model(place, file);
  if (stage == "generate") save_empty("windows", file, stage);
  if (stage == "score") save_record("score", quality_of(place), file, stage);
  if (stage == "diagnose") save_record("diagnosis", diagnosis_of(place), file, stage);
}

int fill_run() {
  std::size_t count = 0;
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream fields(line);
    std::string folder;
    std::string stage;
    std::string method;
    std::string file;
    std::getline(fields, folder, '\t');
    std::getline(fields, stage, '\t');
    std::getline(fields, method, '\t');
    std::getline(fields, file, '\t');
    do_step(folder, stage, file);
    save_log(folder, stage, count++);
  }
  return 0;
}

}  // namespace
}  // namespace piae

int main() { return piae::fill_run(); }

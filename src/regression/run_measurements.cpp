#include "regression/run_measurements.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "artefact/digest.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "diagnosis/catalogue.hpp"
#include "run/cell.hpp"
#include "run/layout.hpp"
#include "run/verdicts.hpp"
#include "scoring/ratios.hpp"

namespace piae::regression {

namespace {

namespace fs = std::filesystem;

/// Returns the names of the folders in a folder, in alphabetical order, without hidden ones, which
/// do not hold results. Empty if the folder does not exist.
std::vector<std::string> folders_in(const fs::path& folder) {
  std::vector<std::string> names;
  if (!fs::is_directory(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && !name.starts_with('.')) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

/// Returns 3 for a folder named "seed3"; an empty value for other folders.
std::optional<std::int64_t> seed_of(const std::string& folder) {
  const std::string prefix = "seed";
  const std::string digits = folder.starts_with(prefix) ? folder.substr(prefix.size()) : "";
  const std::optional<std::int64_t> seed = number_in<std::int64_t>(digits);
  return seed && *seed >= 0 ? seed : std::nullopt;
}

/// The data set of a run that is being read.
struct DatasetOfRun {
  run::Layout layout;
  std::optional<signal::Protocol>
      protocol;  ///< of all cells of the run; empty before the first cell
  Measurements measurements;
};

/// Records what a cell was made with. Refuses a cell with another protocol than those before it.
void note_origin(const artefact::Reader& reader, signal::Protocol protocol, DatasetOfRun& of_run) {
  if (!of_run.protocol) of_run.protocol = protocol;
  if (*of_run.protocol != protocol) {
    throw Error(Exit::bad_input, reader.path().string() + ": the split protocol is " +
                                     to_string(protocol) + ", but other cells of the run have " +
                                     to_string(*of_run.protocol));
  }
  Measurements& measurements = of_run.measurements;
  measurements.protocol = protocol;
  measurements.versions.insert(reader.text(artefact::provenance_group, "version"));
  measurements.settings.insert(reader.text(artefact::provenance_group, "cpu") + "; " +
                               reader.text(artefact::provenance_group, "libraries"));
}

void add_diagnosis(const run::Combination& combination, std::int64_t seed, DatasetOfRun& of_run) {
  Measurements& measurements = of_run.measurements;
  const auto& [method, ratio, classifier] = combination;
  const artefact::Reader reader(of_run.layout.diagnosis(method, ratio, seed, classifier),
                                "diagnosis");
  const run::Diagnosis cell =
      run::read_diagnosis_cell(reader, measurements.dataset, combination, seed);
  note_origin(reader, cell.protocol, of_run);
  measurements.values.push_back({.method = method,
                                 .classifier = classifier,
                                 .ratio = ratio,
                                 .quantity = "accuracy",
                                 .seed = seed,
                                 .value = cell.accuracy});
  if (!cell.type_accuracy) return;
  measurements.values.push_back(measurements.values.back());
  measurements.values.back().quantity = "kind_accuracy";
  measurements.values.back().value = *cell.type_accuracy;
}

void add_score(const std::string& method, std::int64_t seed, DatasetOfRun& of_run) {
  Measurements& measurements = of_run.measurements;
  const artefact::Reader reader(of_run.layout.score(method, seed), "score");
  const scoring::QualityRecord record =
      run::read_score_cell(reader, measurements.dataset, method, seed);
  note_origin(reader, record.protocol, of_run);
  for (const scoring::Metric& metric : scoring::all_metrics()) {
    measurements.values.push_back({.method = method,
                                   .classifier = "",
                                   .ratio = "",
                                   .quantity = metric.name,
                                   .seed = seed,
                                   .value = record.mean_over_classes(metric)});
  }
}

void add_verdicts(const run::Combination& cell, std::int64_t seed, DatasetOfRun& of_run) {
  const run::Layout& layout = of_run.layout;
  const run::Verdicts verdicts = run::read_verdicts(layout, cell, seed);
  note_origin(
      artefact::Reader(layout.classification(cell.method, cell.ratio, seed, cell.classifier),
                       "classification"),
      verdicts.protocol, of_run);
  of_run.measurements.values.push_back(
      {.method = cell.method,
       .classifier = cell.classifier,
       .ratio = cell.ratio,
       .quantity = "right_verdicts",
       .seed = seed,
       .value = static_cast<double>(verdicts.count_right_faults())});
}

/// Returns all possible diagnoses of a method.
std::vector<run::Combination> cells_of(const std::string& method) {
  std::vector<run::Combination> cells;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
      cells.push_back({method, ratio.name, classifier.name});
    }
  }
  return cells;
}

void add_seed(const fs::path& folder, std::int64_t seed, const run::Selection& selection,
              DatasetOfRun& of_run) {
  const run::Layout& layout = of_run.layout;
  for (const std::string& method : folders_in(folder)) {
    for (const run::Combination& cell : cells_of(method)) {
      if (selection.has(cell, seed) &&
          fs::exists(layout.diagnosis(method, cell.ratio, seed, cell.classifier))) {
        add_diagnosis(cell, seed, of_run);
      }
      if (selection.has(cell, seed) &&
          fs::exists(layout.classification(method, cell.ratio, seed, cell.classifier))) {
        add_verdicts(cell, seed, of_run);
      }
    }
    if (selection.has({method, "", ""}, seed) && fs::exists(layout.score(method, seed))) {
      add_score(method, seed, of_run);
    }
  }
}

/// Returns the sort key of the values: classifiers as in their catalogue, ratios as in Table 5,
/// then scores.
auto order_of(const Measured& each) {
  const auto ratio = std::ranges::find(scoring::all_ratios(), each.ratio, &scoring::Ratio::name);
  const auto classifier =
      std::ranges::find(diagnosis::classifiers(), each.classifier, &diagnosis::Classifier::name);
  return std::tuple(each.method, ratio - scoring::all_ratios().begin(),
                    classifier - diagnosis::classifiers().begin(), each.quantity, each.seed);
}

}  // namespace

std::vector<Measurements> read_run(const fs::path& run, const run::Selection& selection) {
  std::vector<Measurements> datasets;
  std::optional<signal::Protocol> protocol;
  for (const std::string& dataset : folders_in(run)) {
    if (!selection.has_dataset(dataset)) continue;
    DatasetOfRun of_run{.layout = run::Layout(run, dataset),
                        .protocol = protocol,
                        .measurements = {.dataset = dataset}};
    for (const std::string& folder : folders_in(run / dataset)) {
      if (const auto seed = seed_of(folder)) {
        add_seed(run / dataset / folder, *seed, selection, of_run);
      }
    }
    protocol = of_run.protocol;
    Measurements& measurements = of_run.measurements;
    if (measurements.values.empty()) continue;
    std::ranges::sort(measurements.values, {}, order_of);
    datasets.push_back(std::move(measurements));
  }
  if (datasets.empty()) {
    throw Error(Exit::input_missing,
                run.string() +
                    ": has none of the requested diagnoses, scores and verdicts; run `make all` "
                    "or `make verdicts` with the same variables");
  }
  return datasets;
}

}  // namespace piae::regression

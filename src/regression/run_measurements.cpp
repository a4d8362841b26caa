#include "regression/run_measurements.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "run/collect.hpp"
#include "run/layout.hpp"
#include "scoring/ratios.hpp"

namespace piae::regression {

namespace {

namespace fs = std::filesystem;

/// Names of the folders in a folder, in alphabetical order; hidden ones hold no results.
std::vector<std::string> folders_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && !name.starts_with('.')) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

/// Of a folder named "seed3"; empty for any other.
std::optional<std::int64_t> seed_of(const std::string& folder) {
  const std::string prefix = "seed";
  const std::string digits = folder.starts_with(prefix) ? folder.substr(prefix.size()) : "";
  const std::optional<std::int64_t> seed = number_in<std::int64_t>(digits);
  return seed && *seed >= 0 ? seed : std::nullopt;
}

void note_origin(const fs::path& file, Measurements& measurements) {
  const artefact::Reader reader(file, "");
  const std::string provenance = "/provenance";
  measurements.versions.insert(reader.text(provenance, "version"));
  measurements.settings.insert(reader.text(provenance, "cpu") + "; " +
                               reader.text(provenance, "libraries"));
}

void require_protocol(const fs::path& file, const std::string& protocol,
                      Measurements& measurements) {
  if (measurements.protocol.empty()) measurements.protocol = protocol;
  if (measurements.protocol == protocol) return;
  throw Error(Exit::bad_input, file.string() + ": the split protocol is " + protocol +
                                   ", other cells of the run have " + measurements.protocol);
}

/// One cell, by the rules of collect().
run::Results read_cell(const run::Layout& layout, const run::Grid& cell) {
  run::Results results = collect(layout, cell);
  if (!results.problems.empty()) throw Error(results.exit, results.problems.front());
  return results;
}

void add_diagnosis(const run::Layout& layout, const run::Combination& place, std::int64_t seed,
                   Measurements& measurements) {
  const fs::path file = layout.diagnosis(place.method, place.ratio, seed);
  const run::Results cell = read_cell(layout, {measurements.dataset, {}, {place}, {seed}});
  require_protocol(file, cell.diagnoses.front().protocol, measurements);
  note_origin(file, measurements);
  measurements.values.push_back(
      {place.method, place.ratio, "accuracy", seed, cell.diagnoses.front().accuracy});
}

double mean_over_classes(const scoring::QualityRecord& record, const scoring::Metric& metric) {
  double sum = 0;
  for (const scoring::ClassQuality& quality : record.classes) sum += quality.*metric.value;
  return sum / static_cast<double>(record.classes.size());
}

void add_score(const run::Layout& layout, const std::string& method, std::int64_t seed,
               Measurements& measurements) {
  const fs::path file = layout.score(method, seed);
  const run::Results cell = read_cell(layout, {measurements.dataset, {method}, {}, {seed}});
  const scoring::QualityRecord& record = cell.qualities.front();
  require_protocol(file, record.protocol, measurements);
  note_origin(file, measurements);
  for (const scoring::Metric& metric : scoring::all_metrics()) {
    measurements.values.push_back(
        {method, "", metric.name, seed, mean_over_classes(record, metric)});
  }
}

void add_seed(const run::Layout& layout, const fs::path& folder, std::int64_t seed,
              const run::Selection& selection, Measurements& measurements) {
  for (const std::string& method : folders_in(folder)) {
    for (const scoring::Ratio& ratio : scoring::all_ratios()) {
      if (selection.has(method, ratio.name, seed) &&
          fs::exists(layout.diagnosis(method, ratio.name, seed))) {
        add_diagnosis(layout, {method, ratio.name}, seed, measurements);
      }
    }
    if (selection.has(method, "", seed) && fs::exists(layout.score(method, seed))) {
      add_score(layout, method, seed, measurements);
    }
  }
}

/// Ratios as in Table 5, scores after them.
auto order_of(const Measured& each) {
  const auto ratio = std::ranges::find(scoring::all_ratios(), each.ratio, &scoring::Ratio::name);
  return std::tuple(each.method, ratio - scoring::all_ratios().begin(), each.quantity, each.seed);
}

}  // namespace

std::vector<Measurements> read_run(const fs::path& run, const run::Selection& selection) {
  std::vector<Measurements> datasets;
  if (fs::is_directory(run)) {
    std::string protocol;
    for (const std::string& dataset : folders_in(run)) {
      if (!selection.has_dataset(dataset)) continue;
      Measurements measurements{dataset, protocol, {}, {}, {}};
      for (const std::string& folder : folders_in(run / dataset)) {
        if (const auto seed = seed_of(folder)) {
          add_seed(run::Layout(run, dataset), run / dataset / folder, *seed, selection,
                   measurements);
        }
      }
      if (measurements.values.empty()) continue;
      std::ranges::sort(measurements.values, {}, order_of);
      protocol = measurements.protocol;
      datasets.push_back(std::move(measurements));
    }
  }
  if (datasets.empty()) {
    throw Error(Exit::input_missing,
                run.string() +
                    ": holds no diagnosis or score of those asked for (`make all` with "
                    "the same variables makes them)");
  }
  return datasets;
}

}  // namespace piae::regression

#include "readings/measure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "artefact/reader.hpp"
#include "augment/catalogue.hpp"
#include "diagnosis/inputs.hpp"
#include "diagnosis/nearest.hpp"
#include "diagnosis/training_set.hpp"
#include "run/cell.hpp"
#include "scoring/identifiability.hpp"
#include "scoring/ratios.hpp"
#include "scoring/statistics.hpp"
#include "signal/roles.hpp"
#include "twin/outcome.hpp"
#include "twin/physics.hpp"

namespace piae::readings {

namespace {

using All = std::vector<Measured>;

/// Windows of a cell, and the model that made some of them.
class Cell {
 public:
  Cell(const run::Layout& layout, const std::string& folder, std::int64_t seed)
      : layout_(layout), folder_(folder), seed_(seed) {}

  [[nodiscard]] artefact::Reader windows(const char* role) const {
    return {layout_.windows(role, seed_), "windows"};
  }
  [[nodiscard]] artefact::Reader generated() const {
    return {layout_.generated_windows(folder_, seed_), "windows"};
  }
  [[nodiscard]] artefact::Reader model() const { return {layout_.model(folder_, seed_), "model"}; }
  [[nodiscard]] artefact::Reader score() const { return {layout_.score(folder_, seed_), "score"}; }
  [[nodiscard]] artefact::Reader diagnosis(const std::string& ratio) const {
    return {layout_.diagnosis(folder_, ratio, seed_), "diagnosis"};
  }
  [[nodiscard]] std::int64_t seed() const { return seed_; }

 private:
  const run::Layout& layout_;
  std::string folder_;
  std::int64_t seed_;
};

double nearest_accuracy(const diagnosis::Inputs& inputs, const scoring::Ratio& ratio) {
  const signal::WindowSet training = diagnosis::compose_training_set(
      inputs.normal, inputs.known, &*inputs.generated, ratio.generated_per_class);
  const std::vector<Label> named =
      diagnosis::most_likely(diagnosis::Nearest(training).outputs(inputs.test, "--test").scores,
                             training.info.classes.size());
  std::size_t right = 0;
  for (std::size_t i = 0; i < named.size(); ++i) right += named[i] == inputs.test.labels[i];
  return 100.0 * static_cast<double>(right) / static_cast<double>(named.size());
}

void add_accuracies(const Cell& cell, const run::Grid& grid, All& all) {
  const artefact::Reader generated = cell.generated();
  const diagnosis::Inputs inputs =
      diagnosis::read_inputs(cell.windows("A"), cell.windows("B"), cell.windows("C"), &generated);
  for (const run::Combination& combination : grid.combinations) {
    const run::Diagnosis found = run::read_diagnosis_cell(cell.diagnosis(combination.ratio),
                                                          grid.dataset, combination, cell.seed());
    all.push_back({"accuracy", combination.ratio, 100 * found.accuracy});
    all.push_back({"nearest", combination.ratio,
                   nearest_accuracy(inputs, scoring::find_ratio(combination.ratio))});
  }
}

void add_quality(const Cell& cell, const std::string& dataset, All& all) {
  const auto record =
      run::read_score_cell(cell.score(), dataset, augment::paper_method(), cell.seed());
  for (const scoring::Metric& metric : scoring::all_metrics()) {
    all.push_back({metric.name, "", record.mean_over_classes(metric)});
  }
}

void add_loss(const std::string& loss, const std::string& weight, const twin::WeightedLoss& at_end,
              All& all) {
  all.push_back({loss, "", at_end.loss});
  all.push_back({weight, "", at_end.weight});
  all.push_back({weight + "_of_stationary", "", at_end.of_stationary()});
}

/// Adds the mean, the standard deviation divided by the mean, and the share of the variance between
/// classes.
void add_spread(const std::string& quantity, const std::vector<double>& values,
                const std::vector<Label>& labels, All& all) {
  const scoring::Summary summary = scoring::summarise(values);
  all.push_back({quantity, "", summary.mean});
  if (summary.deviation) {
    all.push_back({quantity + "_spread", "", *summary.deviation / summary.mean});
  }
  all.push_back(
      {quantity + "_between_classes", "", scoring::share_between_classes(values, labels)});
}

void add_outcome(const Cell& cell, const artefact::Reader& model, All& all) {
  constexpr double least_damping_ns_per_m = 10;  // paper 3.3.1: "from 10 to 10^4 N s/m"
  const twin::Outcome outcome = twin::read_outcome(model);
  add_loss("L_DDL", "alpha", outcome.differential, all);
  add_loss("L_DT", "beta", outcome.twin, all);
  add_loss("L_Rec", "gamma", outcome.reconstruction, all);
  std::vector<double> stiffness;
  std::vector<double> damping;
  for (const twin::TwinPoint& state : outcome.states) {
    stiffness.push_back(twin::in_units(state).stiffness_n_per_m);
    damping.push_back(twin::in_units(state).damping_ns_per_m);
  }
  const auto percent = [&](auto count) {
    return 100.0 * static_cast<double>(count) / static_cast<double>(outcome.states.size());
  };
  all.push_back({"open_contacts", "", percent(outcome.open_contacts)});
  all.push_back({"low_damping", "", percent(std::ranges::count_if(damping, [](double c) {
                   return c < least_damping_ns_per_m;
                 }))});
  const std::vector<Label> labels = signal::read_window_set(cell.windows("C")).labels;
  add_spread("stiffness", stiffness, labels, all);
  add_spread("damping", damping, labels, all);
}

/// Adds the agreement with the true parameters, if they are known.
void add_agreement(const Cell& cell, const artefact::Reader& model, All& all) {
  const artefact::Reader real = cell.windows("D");
  const signal::WindowSet windows = signal::read_window_set(real);
  if (windows.parameters.empty()) return;
  signal::require_same_split(model, real);
  const auto inferred = augment::make_method(augment::paper_method())->infer(model, windows, {});
  const auto compare = [&](const std::string& quantity,
                           double signal::DynamicParameters::*parameter) {
    std::vector<double> truth;
    std::vector<double> found;
    for (std::size_t i = 0; i < windows.size(); ++i) {
      truth.push_back(windows.parameters[i].*parameter);
      found.push_back(inferred[i].*parameter);
    }
    const scoring::Agreement agreement = scoring::agreement(truth, found);
    all.push_back({quantity + "_r2", "", agreement.r2});
    all.push_back({quantity + "_bias", "", agreement.bias});
  };
  compare("stiffness", &signal::DynamicParameters::stiffness_n_per_m);
  compare("damping", &signal::DynamicParameters::damping_ns_per_m);
}

}  // namespace

std::vector<Measured> measure(const run::Layout& layout, const Readings& readings,
                              const Reading& reading, std::int64_t seed) {
  const Cell cell(layout, reading.folder(), seed);
  const artefact::Reader model = cell.model();
  All all;
  add_accuracies(cell, readings.grid, all);
  add_quality(cell, readings.grid.dataset, all);
  add_outcome(cell, model, all);
  add_agreement(cell, model, all);
  return all;
}

}  // namespace piae::readings

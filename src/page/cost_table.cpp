#include "page/cost_table.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "page/time_line.hpp"
#include "report/columns.hpp"
#include "report/labels.hpp"
#include "scoring/ratios.hpp"

namespace piae::page {

namespace {

/// What a step was of: dataset/seed0/method, and below it ratio and classifier where it diagnosed.
struct StepPlace {
  std::string dataset;
  std::string method;
  std::string stage;
  std::string ratio = {};
  std::string classifier = {};

  bool operator==(const StepPlace&) const = default;
};

struct TimedStep {
  StepPlace place;
  double processor_s;
};

std::optional<StepPlace> place_of(const run::StepLog& step) {
  std::vector<std::string> parts;
  for (const auto& part : step.file.parent_path()) parts.push_back(part.string());
  if (parts.size() < 3 || !parts[1].starts_with("seed")) return std::nullopt;
  StepPlace place{.dataset = parts[0], .method = parts[2], .stage = step.stage};
  const bool is_generator = step.stage == "train" || step.stage == "generate";
  if (is_generator && parts.size() == 3) return place;
  if (step.stage != "diagnose" || parts.size() != 5) return std::nullopt;
  place.ratio = parts[3];
  place.classifier = parts[4];
  return place;
}

std::vector<TimedStep> timed_steps(const std::vector<run::StepLog>& steps) {
  std::vector<TimedStep> timed;
  for (const run::StepLog& step : steps) {
    const auto place = place_of(step);
    const bool is_whole = step.end == run::StepEnd::done && !step.went_on;
    if (place && is_whole && step.processor_s) timed.push_back({*place, *step.processor_s});
  }
  return timed;
}

/// Over the seeds; empty where no step of this place is done.
std::optional<double> mean_time(const std::vector<TimedStep>& steps, const StepPlace& place) {
  double sum = 0;
  std::size_t count = 0;
  for (const TimedStep& step : steps) {
    if (step.place != place) continue;
    sum += step.processor_s;
    ++count;
  }
  return count == 0 ? std::nullopt : std::optional(sum / static_cast<double>(count));
}

text::Cell time_or_none(std::optional<double> seconds) {
  if (!seconds) return report::no_number;
  return report::labelled_cell(*seconds, duration_label(*seconds));
}

/// Without a sum where the time of a part is not known.
text::Cells costs_of(const std::vector<TimedStep>& steps, const StepPlace& diagnosis,
                     double diagnosing_s) {
  text::Cells cells{report::method_label(diagnosis.method), diagnosis.classifier,
                    report::short_ratio_label(diagnosis.ratio), diagnosis.dataset};
  std::optional<double> sum = diagnosing_s;
  for (const char* const stage : {"train", "generate"}) {
    const auto time = mean_time(steps, {diagnosis.dataset, diagnosis.method, stage});
    cells.push_back(time_or_none(time));
    if (diagnosis.method == augment::no_method) continue;
    sum = sum && time ? std::optional(*sum + *time) : std::nullopt;
  }
  cells.push_back(time_or_none(diagnosing_s));
  cells.push_back(time_or_none(sum));
  return cells;
}

void add_costs(const std::vector<TimedStep>& steps, const std::string& dataset,
               text::Table& table) {
  for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
    for (const augment::CatalogueEntry& method : augment::catalogue()) {
      text::Cells with_most_windows;
      for (const scoring::Ratio& ratio : scoring::all_ratios()) {
        const StepPlace place{dataset, method.name, "diagnose", ratio.name, classifier.name};
        const auto time = mean_time(steps, place);
        if (time) with_most_windows = costs_of(steps, place, *time);
      }
      if (!with_most_windows.empty()) table.row(std::move(with_most_windows));
    }
  }
}

}  // namespace

std::optional<report::Section> cost_table(const std::vector<run::StepLog>& steps) {
  const std::vector<TimedStep> timed = timed_steps(steps);
  std::vector<std::string> datasets;
  for (const TimedStep& step : timed) {
    if (std::ranges::count(datasets, step.place.dataset) == 0) {
      datasets.push_back(step.place.dataset);
    }
  }
  text::Table table({"method", "classifier", "ratio", "data set", "train it", "generate",
                     "train and ask the classifier", "together"},
                    4);
  for (const std::string& dataset : datasets) add_costs(timed, dataset, table);
  if (table.rows().empty()) return std::nullopt;
  return report::Section{
      "costs", "Processor time that each method takes of one seed, mean over the seeds",
      "From the lines “step: used” of train.log, generate.log and diagnose.log beside the "
      "artefacts, each with the most generated windows of its method and classifier. What has no "
      "such line, as in older runs, has no time here, nor has a step that went on from a "
      "checkpoint, of which the log has the last part alone.",
      table};
}

}  // namespace piae::page

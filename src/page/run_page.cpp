#include "page/run_page.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "page/html.hpp"
#include "page/table.hpp"
#include "page/time_line.hpp"
#include "report/columns.hpp"
#include "report/labels.hpp"
#include "scoring/ratios.hpp"

namespace piae::page {

namespace {

/// Place of a step, from its folder dataset/seed0/method; a diagnosis adds ratio and classifier.
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

/// Returns the mean over the seeds; nothing if no step of this place is done.
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

/// Returns a row of costs. The sum is missing if the time of a part is unknown.
text::Cells costs_of(const std::vector<TimedStep>& steps, const StepPlace& diagnosis,
                     double diagnosing_s) {
  text::Cells cells{report::method_label(diagnosis.method),
                    diagnosis::marked_name(diagnosis.classifier),
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

using Steps = std::vector<const run::StepLog*>;

text::Cell time_cell(std::optional<double> seconds) {
  if (!seconds) return report::no_number;
  return report::labelled_cell(*seconds, duration_label(*seconds));
}

text::Cell memory_cell(std::optional<double> memory_mb) {
  if (!memory_mb) return report::no_number;
  return report::labelled_cell(*memory_mb, fmt::format("{:.0f} MB", *memory_mb));
}

double elapsed_of(const Steps& steps) {
  double sum = 0;
  for (const run::StepLog* step : steps) sum += step->elapsed_s;
  return sum;
}

/// Returns the sum over the steps that recorded it; nothing if none did.
std::optional<double> processor_time_of(const Steps& steps) {
  std::optional<double> sum;
  for (const run::StepLog* step : steps) {
    if (step->processor_s) sum = sum.value_or(0) + *step->processor_s;
  }
  return sum;
}

std::optional<double> memory_of(const Steps& steps) {
  std::optional<double> most;
  for (const run::StepLog* step : steps) {
    if (step->memory_mb) most = std::max(most.value_or(0), *step->memory_mb);
  }
  return most;
}

/// Steps of similar duration. Training time depends on the method; other stages take about equally
/// long for all methods.
struct StepGroup {
  std::string name;
  Steps steps;
};

std::string group_of(const run::StepLog& step) {
  return step.stage == "train" ? "train " + step.file.parent_path().filename().string()
                               : step.stage;
}

std::vector<StepGroup> step_groups(const std::vector<run::StepLog>& steps) {
  std::vector<StepGroup> groups;
  for (const std::string& stage : stages_in_order(steps)) {
    for (const run::StepLog& step : steps) {
      if (step.stage != stage) continue;
      const std::string name = group_of(step);
      auto group = std::ranges::find(groups, name, &StepGroup::name);
      if (group == groups.end()) group = groups.insert(groups.end(), {name, {}});
      group->steps.push_back(&step);
    }
  }
  return groups;
}

void add_row(text::Table& table, const StepGroup& group) {
  const auto not_done = static_cast<std::size_t>(std::ranges::count_if(
      group.steps, [](const run::StepLog* step) { return step->end != run::StepEnd::done; }));
  const double elapsed = elapsed_of(group.steps);
  const run::StepLog* slowest = *std::ranges::max_element(
      group.steps, {}, [](const run::StepLog* step) { return step->elapsed_s; });
  table.row({group.name, report::count_cell(group.steps.size()), report::count_cell(not_done),
             time_cell(elapsed), time_cell(processor_time_of(group.steps)),
             time_cell(elapsed / static_cast<double>(group.steps.size())),
             time_cell(slowest->elapsed_s), memory_cell(memory_of(group.steps))},
            not_done > 0 ? "bad" : "");
}

report::Section table_of_groups(const std::vector<run::StepLog>& steps) {
  text::Table table({"stage", "steps", "not done", "elapsed, sum", "processor time, sum",
                     "elapsed, mean", "elapsed, longest", "memory, maximum"},
                    1);
  for (const StepGroup& group : step_groups(steps)) add_row(table, group);
  return {"stages", "Time and memory by stage",
          "From the logs next to the artefacts: the lines “step: exit” and “step: used”, which "
          "older runs lack. Memory is the maximum of a single step.",
          table};
}

report::Section table_of_steps(const std::string& title, const Steps& steps) {
  text::Table table({"log", "end", "started", "elapsed", "processor time", "memory"}, 2);
  table.column({"reason"});
  for (const run::StepLog* step : steps) {
    const bool is_open = step->end == run::StepEnd::open;
    text::Cell log;
    log.files = {step->file};
    table.row({log, word_of(step->end),
               report::labelled_cell(*step->started_s, moment_label(*step->started_s)),
               time_cell(is_open ? std::nullopt : std::optional(step->elapsed_s)),
               time_cell(step->processor_s), memory_cell(step->memory_mb), step->reason},
              step->end == run::StepEnd::done ? "" : "bad");
  }
  return {"steps", title, "", table};
}

report::Section slowest_steps(Steps steps) {
  constexpr std::size_t shown = 20;
  std::ranges::stable_sort(steps, std::ranges::greater(),
                           [](const run::StepLog* step) { return step->elapsed_s; });
  steps.resize(std::min(steps.size(), shown));
  return table_of_steps("The slowest steps", steps);
}

/// Summarises the run in a sentence or two.
std::string in_short(const std::vector<run::StepLog>& steps, const Steps& all) {
  double wall_s = 0;
  const std::vector<Session> sessions = sessions_of(steps);
  for (const Session& session : sessions) wall_s += session.end_s - session.begin_s;
  std::string text = fmt::format("{} steps took {}", steps.size(), duration_label(wall_s));
  if (sessions.size() > 1) text += fmt::format(" in {} sessions", sessions.size());
  text += fmt::format("; one after another they would take {}", duration_label(elapsed_of(all)));
  if (const auto processor = processor_time_of(all)) {
    text += fmt::format(", of which {} is processor time", duration_label(*processor));
  }
  text += ".";
  if (const auto memory = memory_of(all)) {
    text += fmt::format(" No step used more than {:.0f} MB of memory.", *memory);
  }
  return text;
}

/// Lists all steps or, if the page would be too long, only those that are not done.
Html list_of_steps(const Steps& all) {
  if (all.size() <= most_listed_steps) {
    return element("details", element("summary", fmt::format("All {} steps", all.size())) +
                                  html(table_of_steps("All steps", all)));
  }
  Steps open;
  std::ranges::copy_if(all, std::back_inserter(open),
                       [](const run::StepLog* step) { return step->end != run::StepEnd::done; });
  const std::size_t shown = std::min(open.size(), most_listed_steps);
  const std::string what = fmt::format(
      "{} steps are too many for a page: their logs are next to their outputs. {} are not done{}",
      all.size(), open.size(),
      shown < open.size() ? fmt::format(", of which {} follow.", shown) : ".");
  open.resize(shown);
  if (open.empty()) return element("p", what);
  return element("p", what) + element("details", element("summary", "Steps that are not done") +
                                                     html(table_of_steps("Steps not done", open)));
}

Html content_of(const std::vector<run::StepLog>& steps) {
  if (steps.empty()) return element("p", "No step of this run has a log.");
  Steps all;
  for (const run::StepLog& step : steps) all.push_back(&step);
  const auto costs = cost_table(steps);
  return element("p", {{"class", "verdict"}}, in_short(steps, all)) +
         element("h2", "When the steps ran") +
         element("p",
                 "One row for each stage, one bar for each step; steps that ran at the same time "
                 "are in separate lanes. A step that is not done has a dashed border. Pauses of "
                 "more than ten minutes are cut "
                 "out.") +
         time_line(steps) + element("h2", "What they took") + html(table_of_groups(steps)) +
         (costs ? html(*costs) : Html()) + html(slowest_steps(all)) + list_of_steps(all);
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
  text::Table table({"method", "classifier", "ratio", "data set", "train generator", "generate",
                     "train and test the classifier", "total"},
                    4);
  for (const std::string& dataset : datasets) add_costs(timed, dataset, table);
  if (table.rows().empty()) return std::nullopt;
  return report::Section{
      "costs", "Processor time of each method for one seed, mean over the seeds",
      "From the lines “step: used” of train.log, generate.log and diagnose.log next to the "
      "artefacts, each with the most generated windows of its method and classifier. Steps without "
      "such a line, as in older runs, have no time here. Neither have steps that continued from a "
      "checkpoint, because their logs cover only the last part.",
      table};
}

std::string run_page(const std::vector<run::StepLog>& steps, const Style& style) {
  const Html header =
      element("header", element("h1", "How it ran") +
                            element("p", Html("Times and memory of this run. Its results: ") +
                                             file_link("report.html") + "."));
  return document("How it ran", style,
                  header + element("main", {{"id", "content"}}, content_of(steps)));
}

}  // namespace piae::page

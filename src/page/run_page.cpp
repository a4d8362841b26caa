#include "page/run_page.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>

#include "page/cost_table.hpp"
#include "page/links.hpp"
#include "page/table.hpp"
#include "page/time_line.hpp"
#include "report/columns.hpp"

namespace piae::page {

namespace {

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

/// Of the steps that have it; empty where none has.
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

/// Steps that are like each other. To train takes another time for each method; other stages take
/// equally long for all.
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
                     "elapsed, mean", "elapsed, longest", "memory, most"},
                    1);
  for (const StepGroup& group : step_groups(steps)) add_row(table, group);
  return {"stages", "Time and memory by stage",
          "From the logs beside the artefacts: the lines “step: exit”, and “step: used”, which "
          "older runs lack. Memory is what one step held at most.",
          table};
}

report::Section table_of_steps(const std::string& title, const Steps& steps) {
  text::Table table({"log", "end", "begun", "elapsed", "processor time", "memory"}, 2);
  table.column({"reason"});
  for (const run::StepLog* step : steps) {
    const bool is_open = step->end == run::StepEnd::open;
    text::Cell log;
    log.files = {step->file};
    table.row({log, word_of(step->end),
               report::labelled_cell(*step->begun_s, moment_label(*step->begun_s)),
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

/// The run as a whole, in a sentence or two.
std::string in_short(const std::vector<run::StepLog>& steps, const Steps& all) {
  double wall_s = 0;
  const std::vector<Session> sessions = sessions_of(steps);
  for (const Session& session : sessions) wall_s += session.end_s - session.begin_s;
  std::string text = fmt::format("{} steps took {}", steps.size(), duration_label(wall_s));
  if (sessions.size() > 1) text += fmt::format(" in {} sessions", sessions.size());
  text += fmt::format("; one after the other they would take {}", duration_label(elapsed_of(all)));
  if (const auto processor = processor_time_of(all)) {
    text += fmt::format(", of which {} is processor time", duration_label(*processor));
  }
  text += ".";
  if (const auto memory = memory_of(all)) {
    text += fmt::format(" No step held more than {:.0f} MB of memory.", *memory);
  }
  return text;
}

/// Each step, or where that would be too long a page those that are not done.
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
      "{} steps are too many for a page: their logs lie beside what they made. {} are not done{}",
      all.size(), open.size(),
      shown < open.size() ? fmt::format(", of which {} follow.", shown) : ".");
  open.resize(shown);
  if (open.empty()) return element("p", what);
  return element("p", what) + element("details", element("summary", "Steps that are not done") +
                                                     html(table_of_steps("Steps not done", open)));
}

Html content_of(const std::vector<run::StepLog>& steps) {
  if (steps.empty()) return element("p", "No step of this run has left a log.");
  Steps all;
  for (const run::StepLog& step : steps) all.push_back(&step);
  const auto costs = cost_table(steps);
  return element("p", {{"class", "verdict"}}, in_short(steps, all)) +
         element("h2", "When the steps ran") +
         element(
             "p",
             "A row for each stage, a bar for each step; what ran at the same time lies in lanes. "
             "A step that is not done has a dashed border. Pauses of more than ten minutes are cut "
             "out.") +
         time_line(steps) + element("h2", "What they took") + html(table_of_groups(steps)) +
         (costs ? html(*costs) : Html()) + html(slowest_steps(all)) + list_of_steps(all);
}

}  // namespace

std::string run_page(const std::vector<run::StepLog>& steps, const Style& style) {
  const Html header = element(
      "header", element("h1", "How it ran") +
                    element("p", Html("Times, and memory, of this very run. What it found: ") +
                                     file_link("report.html") + "."));
  return document("How it ran", style,
                  header + element("main", {{"id", "content"}}, content_of(steps)));
}

}  // namespace piae::page

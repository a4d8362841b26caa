#include "plan/plan.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "base/error.hpp"
#include "plan/contrast_steps.hpp"
#include "plan/grid_steps.hpp"
#include "plan/look_steps.hpp"
#include "plan/table_steps.hpp"
#include "plan/words.hpp"

namespace piae::plan {

namespace {

/// The goal that a file of a run belongs to.
std::string goal_of_file(const std::string& file) {
  const Words parts = fields_of(below_run(file), '/');  // DATASET, seedK, UNIT, ...
  const std::string unit = parts.size() > 3 ? parts[2] : "";
  const std::string name = file_name(file);
  const auto begins = [&](const char* beginning) { return name.starts_with(beginning); };
  if (unit == "sweep" || unit.starts_with("sweep@") || begins("sweep")) return "sweep";
  if (unit == "readings" || begins("readings.")) return "readings";
  if (name == "classifier.h5" || begins("trust.")) return "trust";
  if (begins("transfer")) return "transfer";
  if (begins("identifiability.") || begins("scatter.")) return "identify";
  if (begins("protocols.") || begins("rates.")) return "contrast";
  return "all";
}

void add_goals(const Experiment& experiment, const Choice& choice,
               const std::set<std::string>& goals, GridSteps& grid, TableSteps& tables,
               Judge& judge, Disk& disk, std::vector<std::string>& shown) {
  const auto has = [&](const char* goal) { return goals.contains(goal); };
  if (has("records")) {
    for (const Part& part : choice.parts) grid.records(part.dataset);
  }
  if (has("cells") || has("all")) tables.cells();
  if (has("features") || has("all")) tables.features();
  if (has("sweep")) tables.sweep();
  if (has("readings")) tables.readings();
  if (has("identify")) tables.identify();
  if (has("trust")) tables.trust();
  if (has("transfer")) tables.transfer();
  if (has("contrast")) add_contrasts(experiment, choice, grid.graph(), judge, disk, shown);
  if (has("tables") || has("all")) tables.tables();
}

}  // namespace

Plan::Plan(const Experiment& experiment, Choice choice, Stretch stretch, Disk& disk)
    : choice_(std::move(choice)), judge_(std::make_unique<Judge>(graph_, disk)) {
  if (stretch == Stretch::grid) {
    if (choice_.only_looks) return;
    GridSteps grid(experiment, choice_, choice_.protocol, graph_);
    TableSteps tables(experiment, choice_, grid, *judge_, disk);
    add_goals(experiment, choice_, {choice_.goals.begin(), choice_.goals.end()}, grid, tables,
              *judge_, disk, shown_);
    shown_.insert(shown_.end(), tables.shown().begin(), tables.shown().end());
    std::set<std::string> of_files;
    for (const std::string& file : choice_.files) of_files.insert(goal_of_file(file));
    const StepId first = graph_.steps().size();
    std::vector<std::string> not_shown;
    add_goals(experiment, choice_, of_files, grid, tables, *judge_, disk, not_shown);
    for (StepId id = first; id < graph_.steps().size(); ++id) graph_.at(id).is_asked = false;
    ask_for(choice_.files);
    return;
  }
  const bool draws = choice_.has_goal("all") || choice_.has_goal("figures");
  const bool reports = choice_.has_goal("all") || choice_.has_goal("report");
  GridSteps grid(experiment, choice_, choice_.protocol, graph_);
  TableSteps tables(experiment, choice_, grid, *judge_, disk);
  LookSteps looks(choice_, grid, tables);
  if (stretch == Stretch::numbers && (draws || reports)) looks.numbers();
  if (stretch == Stretch::pictures && (draws || reports)) looks.pictures();
  if (stretch == Stretch::pages && reports) looks.pages(experiment);
}

std::vector<StepId> Plan::asked() const {
  std::vector<StepId> ids;
  for (StepId id = 0; id < graph_.steps().size(); ++id) {
    if (graph_.at(id).is_asked) ids.push_back(id);
  }
  return ids;
}

std::vector<StepId> Plan::to_run() {
  std::vector<StepId> ids = asked();
  std::erase_if(ids, [&](StepId id) {
    const bool is_cell = graph_.at(id).is_artefact;
    return (choice_.with_holes && is_cell) || judge_->of(id).state == State::current;
  });
  return ids;
}

std::vector<StepId> Plan::missing() {
  std::vector<StepId> ids = asked();
  std::erase_if(ids, [&](StepId id) {
    return !graph_.at(id).is_artefact || judge_->of(id).state == State::current;
  });
  return ids;
}

void Plan::keep_only(const std::vector<std::string>& files) {
  for (StepId id = 0; id < graph_.steps().size(); ++id) graph_.at(id).is_asked = false;
  ask_for(files);
}

void Plan::ask_for(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    const auto maker = graph_.maker_of(file);
    if (!maker) throw Error(Exit::usage, file + ": no step makes it, with these variables");
    graph_.at(*maker).is_asked = true;
  }
  for (StepId id = graph_.steps().size(); id-- > 0;) {
    if (!graph_.at(id).is_asked) continue;
    for (const StepId needed : graph_.needs(id)) {
      graph_.at(needed).is_asked = !graph_.at(needed).is_held;
    }
  }
}

std::unique_ptr<Plan> plan_with_holes(const Experiment& experiment, Choice choice, Disk& disk) {
  auto whole = std::make_unique<Plan>(experiment, choice, Stretch::grid, disk);
  const std::vector<StepId> missing = whole->missing();
  if (missing.empty()) return whole;
  choice.with_holes = true;
  if (!choice.has_goal("all") && !choice.has_goal("tables")) {
    std::set<std::int64_t> incomplete;
    for (const StepId id : missing) {
      const auto seed = whole->graph().at(id).place.seed;
      if (seed) incomplete.insert(*seed);
    }
    std::erase_if(choice.seeds, [&](std::int64_t seed) { return incomplete.contains(seed); });
    if (choice.seeds.empty()) {
      throw Error(Exit::input_missing, "of no seed there is all, so there are no tables");
    }
  }
  return std::make_unique<Plan>(experiment, std::move(choice), Stretch::grid, disk);
}

}  // namespace piae::plan

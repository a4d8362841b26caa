#include "plan/plan.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "base/error.hpp"
#include "plan/goals.hpp"
#include "plan/look_steps.hpp"
#include "plan/table_steps.hpp"
#include "plan/words.hpp"

namespace piae::plan {

namespace {

void add_goals(const std::set<std::string>& names, TableSteps& tables) {
  for (const Goal& goal : goals()) {
    if (names.contains(goal.name) && goal.add != nullptr) goal.add(tables);
  }
}

}  // namespace

const char* to_string(Stretch stretch) {
  constexpr std::array<const char*, stretches.size()> words{"grid", "numbers", "pictures", "pages",
                                                            "shown"};
  return words.at(static_cast<std::size_t>(stretch));
}

bool has_steps_in(Stretch stretch, const Choice& choice) {
  const auto any = [&](bool Goal::*does) {
    return std::ranges::any_of(choice.goals,
                               [&](const std::string& name) { return goal_named(name).*does; });
  };
  switch (stretch) {
    case Stretch::grid:
      return true;
    case Stretch::numbers:
    case Stretch::pictures:
      return any(&Goal::draws);
    case Stretch::pages:
      return any(&Goal::writes_pages);
    default:
      return false;
  }
}

Plan::Plan(const Experiment& experiment, Choice choice, Stretch stretch, Disk& disk)
    : choice_(std::move(choice)), judge_(std::make_unique<Judge>(graph_, disk)) {
  GridSteps grid(experiment, choice_, choice_.protocol, graph_);
  TableSteps tables(experiment, choice_, grid, *judge_, disk);
  if (stretch == Stretch::grid) {
    if (!choice_.only_looks) add_grid(tables);
    return;
  }
  if (!has_steps_in(stretch, choice_)) return;
  LookSteps looks(choice_, grid, tables);
  if (stretch == Stretch::numbers) looks.numbers();
  if (stretch == Stretch::pictures) looks.pictures();
  if (stretch == Stretch::pictures && choice_.only_pictures) keep_only(*choice_.only_pictures);
  if (stretch == Stretch::pages) looks.pages(experiment);
}

void Plan::add_grid(TableSteps& tables) {
  add_goals({choice_.goals.begin(), choice_.goals.end()}, tables);
  shown_ = tables.shown();
  const StepId first = graph_.steps().size();
  std::set<std::string> of_files;
  for (const std::string& file : choice_.files) of_files.insert(goal_of_file(file).name);
  add_goals(of_files, tables);
  for (StepId id = first; id < graph_.steps().size(); ++id) graph_.at(id).is_requested = false;
  request_files(choice_.files);
}

std::vector<StepId> Plan::requested() const {
  std::vector<StepId> ids;
  for (StepId id = 0; id < graph_.steps().size(); ++id) {
    if (graph_.at(id).is_requested) ids.push_back(id);
  }
  return ids;
}

std::vector<StepId> Plan::to_run() {
  std::vector<StepId> ids = requested();
  judge_->read_ahead(ids);
  std::erase_if(ids, [&](StepId id) {
    const bool is_cell = graph_.at(id).is_artefact;
    return (choice_.with_missing && is_cell) || judge_->of(id).state == State::current;
  });
  return ids;
}

std::vector<StepId> Plan::missing() {
  std::vector<StepId> ids = requested();
  judge_->read_ahead(ids);
  std::erase_if(ids, [&](StepId id) {
    return !graph_.at(id).is_artefact || judge_->of(id).state == State::current;
  });
  return ids;
}

void Plan::keep_only(const std::vector<std::string>& files) {
  for (StepId id = 0; id < graph_.steps().size(); ++id) graph_.at(id).is_requested = false;
  request_files(files);
}

void Plan::keep_pages() {
  for (const StepId id : requested()) {
    Step& step = graph_.at(id);
    if (step.is_always_due) step.is_requested = judge_->of(id).only_missing;
  }
}

void Plan::request_files(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    const auto maker = graph_.maker_of(file);
    if (!maker)
      throw Error(Exit::usage, file +
                                   ": no step makes this file with the given DATASETS, METHODS, "
                                   "RATIOS, CLASSIFIERS and SEEDS; change these");
    graph_.at(*maker).is_requested = true;
  }
  for (StepId id = graph_.steps().size(); id-- > 0;) {
    if (!graph_.at(id).is_requested) continue;
    for (const StepId needed : graph_.needs(id)) {
      graph_.at(needed).is_requested = !graph_.at(needed).is_held;
    }
  }
}

std::unique_ptr<Plan> plan_with_missing(const Experiment& experiment, Choice choice, Disk& disk) {
  auto whole = std::make_unique<Plan>(experiment, choice, Stretch::grid, disk);
  const std::vector<StepId> missing = whole->missing();
  if (missing.empty()) return whole;
  choice.with_missing = true;
  if (!choice.has_goal("all") && !choice.has_goal("tables")) {
    std::set<std::int64_t> incomplete;
    for (const StepId id : missing) {
      const auto seed = whole->graph().at(id).place.seed;
      if (seed) incomplete.insert(*seed);
    }
    std::erase_if(choice.seeds, [&](std::int64_t seed) { return incomplete.contains(seed); });
    if (choice.seeds.empty()) {
      throw Error(
          Exit::input_missing,
          "no seed is complete, so there are no tables; `make status` shows what is missing");
    }
  }
  return std::make_unique<Plan>(experiment, std::move(choice), Stretch::grid, disk);
}

}  // namespace piae::plan

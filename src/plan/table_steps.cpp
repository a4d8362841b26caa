#include "plan/table_steps.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "diagnosis/catalogue.hpp"
#include "plan/words.hpp"
#include "run/layout.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/ratios.hpp"

namespace piae::plan {

namespace {

/// Returns the ratio, among these, at which a method has the most generated windows.
std::string last_ratio(const std::string& method, const Words& ratios) {
  std::string last;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    if (has(ratios, ratio.name) && run::go_together(method, ratio)) last = ratio.name;
  }
  return last;
}

/// Returns the tables that the paper publishes.
Words published(Disk& disk) {
  Words files;
  for (const std::string& name : disk.files_below("results/published")) {
    if (name.ends_with(".csv")) files.push_back("results/published/" + name);
  }
  if (files.empty()) {
    throw Error(Exit::input_missing,
                "results/published does not hold a table, but the paper's tables are shown next to "
                "our results; restore it with `git checkout results/published`");
  }
  return files;
}

}  // namespace

std::string nothing_generated() { return scoring::all_ratios().front().name; }

Input input_of_published(Disk& disk) {
  return {.role = "published tables", .files = published(disk), .is_option = false};
}

std::string TableSteps::folder_of(const Dataset& dataset) const {
  return grid_.folder() + '/' + dataset.name;
}

std::vector<StepId> TableSteps::cells_of(const Part& part) {
  std::vector<StepId> ids;
  for (const std::int64_t seed : choice_.seeds) {
    for (const run::Combination& cell : part.cells) {
      ids.push_back(grid_.diagnosis(part.dataset, seed, variant_of(cell.method), cell.ratio,
                                    cell.classifier));
    }
    for (const std::string& method : part.methods) {
      if (run::has_score(method))
        ids.push_back(grid_.score(part.dataset, seed, variant_of(method)));
    }
  }
  return ids;
}

void TableSteps::cells() {
  for (const Part& part : choice_.parts) cells_of(part);
}

void TableSteps::features() {
  for (const Part& part : choice_.parts) {
    for (const std::string& method : part.methods) {
      const bool by_papers = std::ranges::any_of(part.cells, [&](const run::Combination& cell) {
        return cell.method == method && cell.classifier == scoring::paper_classifier;
      });
      if (by_papers) {
        grid_.features(part.dataset, choice_.lowest_seed, method,
                       last_ratio(method, choice_.ratios));
      }
    }
  }
}

const std::vector<HeldCell>& TableSteps::held(const Dataset& dataset) {
  const auto found = held_.find(dataset.name);
  if (found != held_.end()) return found->second;
  return held_[dataset.name] = held_cells(experiment_, disk_.files_below(folder_of(dataset)));
}

StepId TableSteps::step_of(const Dataset& dataset, const HeldCell& cell) {
  switch (cell.kind) {
    case HeldCell::Kind::model:
      return grid_.model(dataset, cell.seed, cell.variant);
    case HeldCell::Kind::score:
      return grid_.score(dataset, cell.seed, cell.variant);
    default:
      return grid_.diagnosis(dataset, cell.seed, cell.variant, cell.ratio, cell.classifier);
  }
}

/// Returns the topmost folder, below the data set's, in which everything is stale; else the file. A
/// stale model makes everything of its method stale.
std::string TableSteps::name_of_left_out(const Dataset& dataset, const HeldCell& cell, StepId id) {
  const auto is_old = [&](StepId each) {
    const Verdict& verdict = judge_.of(each);
    return verdict.state != State::current && !verdict.only_missing;
  };
  std::string seed = "seed" + std::to_string(cell.seed);
  if (is_old(grid_.split(dataset, cell.seed))) return seed;
  const bool generates = cell.variant.method != augment::no_method;
  const bool is_model = cell.kind == HeldCell::Kind::model;
  if (is_model || (generates && is_old(grid_.windows(dataset, cell.seed, cell.variant)))) {
    return seed + '/' + cell.variant.folder;
  }
  return grid_.graph().at(id).outputs.front().substr(folder_of(dataset).size() + 1);
}

/// Returns the chosen cells that the run holds, with the steps that made them.
std::vector<std::pair<const HeldCell*, StepId>> TableSteps::held_steps(const Dataset& dataset,
                                                                       const Chosen& chosen) {
  std::vector<std::pair<const HeldCell*, StepId>> steps;
  std::vector<StepId> ids;
  for (const HeldCell& cell : held(dataset)) {
    if (!chosen(cell)) continue;
    ids.push_back(step_of(dataset, cell));
    steps.emplace_back(&cell, ids.back());
  }
  judge_.read_ahead(ids);
  return steps;
}

TableCells TableSteps::with_held(const Dataset& dataset, const std::vector<StepId>& requested,
                                 const Chosen& chosen, bool only_looks) {
  grid_.request(false);
  const auto steps = held_steps(dataset, chosen);
  TableCells cells;
  std::set<std::string> taken;
  const auto take = [&](const std::string& file) {
    if (taken.insert(file).second) cells.files.push_back(file);
  };
  for (const StepId id : requested) take(grid_.graph().at(id).outputs.front());
  std::set<std::string> left_out;
  Words old;
  for (const auto& [cell, id] : steps) {
    const std::string file = grid_.graph().at(id).outputs.front();
    if (taken.contains(file)) continue;
    const Verdict& verdict = judge_.of(id);
    if (verdict.state == State::current || verdict.only_missing) {
      take(file);
    } else {
      left_out.insert(name_of_left_out(dataset, *cell, id));
      old.push_back(file);
    }
  }
  grid_.request(true);
  if (only_looks && cells.files.empty()) {
    cells.files = old;
  } else {
    cells.left_out.assign(left_out.begin(), left_out.end());
  }
  return cells;
}

void TableSteps::add(Step step, const std::string& role, const Words& files) {
  step.inputs.insert(step.inputs.begin(), {.role = role, .files = files, .is_option = false});
  step.is_artefact = false;
  if (step.log.empty()) step.log = step.stage;
  grid_.graph().add(std::move(step));
}

Words TableSteps::add_for_cells(const Part& part, StepOfCell step_of_cell) {
  Words files;
  for (const std::int64_t seed : choice_.seeds) {
    for (const run::Combination& cell : part.cells) {
      const StepId id =
          (grid_.*step_of_cell)(part.dataset, seed, cell.method, cell.ratio, cell.classifier);
      files.push_back(grid_.graph().at(id).outputs.front());
    }
  }
  return files;
}

void TableSteps::add_picture(const std::string& csv, const Words& joined) {
  const std::string name = csv.substr(0, csv.size() - std::string(".csv").size());
  Words scripts;
  for (const std::string& script : disk_.files_below("pipeline/figures")) {
    scripts.push_back("pipeline/figures/" + script);
  }
  Step step{.stage = "draw",
            .folder = csv.substr(0, csv.rfind('/')),
            .log = file_name(name) + ".svg",
            .inputs = {{.role = "scripts", .files = scripts, .is_option = false}},
            .outputs = {name + ".svg", name + ".pdf"}};
  if (!joined.empty()) step.outputs.push_back(csv);
  add(std::move(step), "numbers", joined.empty() ? Words{csv} : joined);
}

Words TableSteps::whole_selection() const {
  Words words;
  append_option(words, "methods", choice_.methods);
  append_option(words, "ratios", choice_.ratios);
  append_option(words, "seeds", texts_of(choice_.seeds));
  append_option(words, "classifiers", choice_.classifiers);
  return words;
}

Words TableSteps::selection(const Part& part) const {
  Words words;
  append_option(words, "methods", part.methods);
  append_option(words, "ratios", choice_.ratios);
  append_option(words, "seeds", texts_of(choice_.seeds));
  append_option(words, "classifiers", choice_.classifiers);
  if (!part.dataset.any_known) append_option(words, "nothing-known", {part.dataset.name});
  return words;
}

/// Drops the missing cells. Puts into `one_cell` the options that name one of the others, which a
/// table needs.
std::vector<StepId> TableSteps::without_missing(std::vector<StepId> requested, Words& one_cell) {
  judge_.read_ahead(requested);
  std::erase_if(requested, [&](StepId id) { return judge_.of(id).state != State::current; });
  for (const StepId id : requested) {
    const Place& place = grid_.graph().at(id).place;
    if (place.ratio.empty()) continue;
    append_option(one_cell, "methods", {place.method});
    append_option(one_cell, "ratios", {place.ratio});
    append_option(one_cell, "seeds", {std::to_string(*place.seed)});
    append_option(one_cell, "classifiers", {place.classifier});
    break;
  }
  return requested;
}

void TableSteps::add_tables(const Part& part) {
  const Dataset& dataset = part.dataset;
  std::vector<StepId> requested = cells_of(part);
  Words selected = selection(part);
  if (choice_.with_missing) {
    selected.clear();
    requested = without_missing(std::move(requested), selected);
    if (selected.empty()) return;
  }
  const TableCells cells = with_held(dataset, requested, [&](const HeldCell& cell) {
    return cell.kind != HeldCell::Kind::model && cell.variant.folder == cell.variant.method;
  });
  Step step{.stage = "tabulate",
            .folder = folder_of(dataset),
            .settings = grid_.settings().of("tabulate"),
            .inputs = {input_of_published(disk_)},
            .words = {"--run", grid_.folder(), "--dataset", dataset.name},
            .outputs = in_folder(folder_of(dataset), run::table_names),
            .place = {.dataset = dataset.name}};
  append(step.words, selected);
  if (choice_.with_missing && !dataset.any_known) {
    append_option(step.words, "nothing-known", {dataset.name});
  }
  append_option(step.words, "leave-out", cells.left_out);
  append_option(step.words, "published", {"results/published"});
  if (choice_.has_goal("all")) shown_.push_back(step.outputs.back());
  add(std::move(step), "cells", cells.files);
}

void TableSteps::tables() {
  for (const Part& part : choice_.parts) add_tables(part);
}

/// Returns the ratios of a table of moved settings: the given ones, else `otherwise`.
Words TableSteps::moved_ratios(const Words& otherwise, const std::string& goal) const {
  Words ratios;
  for (const std::string& ratio : choice_.ratios_given ? choice_.ratios : otherwise) {
    if (ratio != nothing_generated()) ratios.push_back(ratio);
  }
  if (ratios.empty()) {
    throw Error(
        Exit::usage,
        fmt::format("make {}: RATIOS must include one other than {}, at which nothing is generated",
                    goal, nothing_generated()));
  }
  return ratios;
}

}  // namespace piae::plan

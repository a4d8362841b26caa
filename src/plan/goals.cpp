#include "plan/goals.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>

#include "base/error.hpp"
#include "plan/contrast_steps.hpp"
#include "plan/identify_steps.hpp"
#include "plan/readings_steps.hpp"
#include "plan/sweep_steps.hpp"
#include "plan/transfer_steps.hpp"
#include "plan/trust_steps.hpp"
#include "plan/verdict_steps.hpp"
#include "plan/words.hpp"

namespace piae::plan {

namespace {

void add_records(TableSteps& tables) {
  for (const Part& part : tables.choice().parts) tables.grid().records(part.dataset);
}
void add_cells(TableSteps& tables) { tables.cells(); }
void add_features(TableSteps& tables) { tables.features(); }
void add_tables(TableSteps& tables) { tables.tables(); }
void add_all(TableSteps& tables) {
  tables.cells();
  tables.features();
  tables.tables();
}

}  // namespace

const std::vector<Goal>& goals() {
  const Words scored{"score", "diagnose"};
  // Cells come before tables, because tables leave out cells that are stale and not requested.
  static const std::vector<Goal> all{
      {.name = "records", .add = add_records},
      {.name = "cells", .add = add_cells, .counts = scored, .is_submitted = true},
      {.name = "features", .add = add_features},
      {.name = "sweep",
       .add = add_sweeps,
       .counts = scored,
       .is_submitted = true,
       .beginnings = {"sweep"}},
      {.name = "readings",
       .add = add_readings,
       .counts = scored,
       .is_submitted = true,
       .beginnings = {"readings"}},
      {.name = "identify",
       .add = add_identifications,
       .counts = {"train"},
       .is_submitted = true,
       .beginnings = {"identifiability.", "scatter."}},
      {.name = "trust",
       .add = add_trust,
       .counts = {"score", "diagnose", "classifier"},
       .beginnings = {"trust.", "classifier.h5"}},
      {.name = "verdicts",
       .add = add_verdicts,
       .counts = {"diagnose", "classifier", "classify"},
       .beginnings = {"verdicts.", "classification.h5"}},
      {.name = "transfer",
       .add = add_transfers,
       .counts = scored,
       .beginnings = {"transfer", "rigs"}},
      {.name = "contrast",
       .add = add_contrasts,
       .counts = scored,
       .is_submitted = true,
       .beginnings = {"protocols.", "rates."}},
      {.name = "tables", .add = add_tables},
      {.name = "all",
       .add = add_all,
       .counts = scored,
       .is_submitted = true,
       .draws = true,
       .writes_pages = true},
      {.name = "figures", .draws = true, .beginnings = {"figures"}},
      {.name = "report",
       .draws = true,
       .writes_pages = true,
       .beginnings = {"report.html", "report.md", "run.html"}},
  };
  return all;
}

std::vector<std::string> goal_names() {
  Words names;
  for (const Goal& goal : goals()) names.push_back(goal.name);
  return names;
}

const Goal& goal_named(const std::string& name) {
  return *std::ranges::find(goals(), name, &Goal::name);
}

const Goal& goal_of_file(const std::string& file) {
  const Words parts = fields_of(below_run(file), '/');  // DATASET, seedK, UNIT, ... or figures
  if (parts.empty()) return goal_named("all");
  const bool is_of_seed = parts.size() > 3;
  const std::string folder = is_of_seed ? parts[2] : parts.size() > 2 ? parts[1] : "";
  const auto begins_so = [&](const std::string& beginning) {
    return folder.starts_with(beginning) || parts.back().starts_with(beginning);
  };
  const auto found = std::ranges::find_if(
      goals(), [&](const Goal& goal) { return std::ranges::any_of(goal.beginnings, begins_so); });
  return found == goals().end() ? goal_named("all") : *found;
}

void require_one_that(bool (*is_so)(const Goal&), const std::vector<std::string>& names) {
  Words able;
  for (const Goal& goal : goals()) {
    if (is_so(goal)) able.push_back(goal.name);
  }
  if (names.size() == 1 && has(able, names.front())) return;
  throw Error(Exit::usage,
              fmt::format("give one goal of {}, not '{}'", fmt::join(able, ", "), spaced(names)));
}

}  // namespace piae::plan

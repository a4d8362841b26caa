#include "plan/transfer_steps.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "base/error.hpp"
#include "plan/words.hpp"
#include "run/layout.hpp"
#include "scoring/ratios.hpp"

namespace piae::plan {

namespace {

std::vector<const Part*> parts_of(const TableSteps& tables, const settings::Group& group) {
  std::vector<const Part*> parts;
  for (const std::string& name : group.datasets) {
    const auto found = std::ranges::find_if(
        tables.choice().parts, [&](const Part& part) { return part.dataset.name == name; });
    if (found != tables.choice().parts.end()) parts.push_back(&*found);
  }
  return parts;
}

/// Returns the requested ratio with the most generated windows.
std::string generating_ratio(const Choice& choice) {
  std::string last;
  for (const scoring::Ratio& each : scoring::all_ratios()) {
    if (each.generated_per_class > 0 && has(choice.ratios, each.name)) last = each.name;
  }
  if (!last.empty()) return last;
  throw Error(
      Exit::usage,
      fmt::format(
          "make transfer: RATIOS must include one other than {}, at which nothing is generated",
          nothing_generated()));
}

/// Returns the cells of a group's data sets without generated windows, and with most of them. If no
/// classifiers are requested, these are the cells that the main tables show.
Words cells_of(TableSteps& tables, const settings::Group& group, const std::string& ratio) {
  const bool only_shown = !tables.choice().classifiers_given;
  Words files;
  for (const Part* part : parts_of(tables, group)) {
    for (const std::int64_t seed : tables.choice().seeds) {
      for (const run::Combination& cell : part->cells) {
        if (cell.ratio != nothing_generated() && cell.ratio != ratio) continue;
        if (only_shown && !group.choices.shows(cell.method, cell.classifier)) continue;
        const StepId id = tables.grid().diagnosis(part->dataset, seed, variant_of(cell.method),
                                                  cell.ratio, cell.classifier);
        files.push_back(tables.grid().graph().at(id).outputs.front());
      }
    }
  }
  return files;
}

void add_transfer(TableSteps& tables, const settings::Group& group) {
  const std::string ratio = generating_ratio(tables.choice());
  const std::string name = "transfer@" + group.name;
  Step step{.stage = "transfer",
            .folder = tables.grid().folder(),
            .log = name,
            .settings = tables.grid().settings().of("transfer", group.name),
            .options = {{"group", group.name},
                        {"methods", spaced(tables.choice().methods)},
                        {"ratio", ratio},
                        {"seeds", spaced(texts_of(tables.choice().seeds))}},
            .words = {"--run", tables.grid().folder()},
            .outputs = in_folder(
                tables.grid().folder(),
                {name + ".csv", "transfer-comparisons@" + group.name + ".csv", name + ".md"})};
  if (tables.choice().classifiers_given) {
    step.options.emplace_back("classifiers", spaced(tables.choice().classifiers));
  }
  tables.show(step.outputs.back());
  tables.add(std::move(step), "cells", cells_of(tables, group, ratio));
  tables.add_picture(tables.grid().folder() + '/' + name + ".csv");
}

}  // namespace

void add_transfers(TableSteps& tables) {
  Words made;
  Words groups;
  for (const settings::Group& group : tables.experiment().groups) {
    Words there;
    for (const std::string& dataset : group.datasets) {
      if (tables.experiment().find(dataset) != nullptr) there.push_back(dataset);
    }
    groups.push_back(fmt::format("{} ({})", group.name, spaced(there)));
    if (parts_of(tables, group).size() < there.size()) continue;
    settings::require_datasets(tables.experiment().protocol, group.name,
                               tables.experiment().pipeline);
    add_transfer(tables, group);
    made.push_back(fmt::format("{}/transfer@{}.csv", tables.grid().folder(), group.name));
  }
  if (made.size() > 1) tables.add_picture(tables.grid().folder() + "/rigs.csv", made);
  if (!made.empty()) return;
  throw Error(Exit::usage,
              fmt::format("make transfer: DATASETS must include all data sets of one group: {}",
                          spaced(groups)));
}

}  // namespace piae::plan

#include "plan/sweep_steps.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <set>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "plan/words.hpp"
#include "run/layout.hpp"

namespace piae::plan {

namespace {

/// Returns the method as it is, and with each setting moved.
std::vector<Variant> swept_variants(const settings::Sweep& sweep) {
  std::vector<Variant> variants{variant_of(sweep.method)};
  for (const std::string& point : sweep.points) {
    if (has(sweep.centre, point)) continue;
    variants.push_back({.folder = sweep_folder(sweep.method, point),
                        .method = sweep.method,
                        .moved = {*settings::parse_point(point)}});
  }
  return variants;
}

void add_sweep(TableSteps& tables, const Part& part, const settings::Sweep& sweep) {
  const Dataset& dataset = part.dataset;
  const Words ratios = tables.moved_ratios({"1to1"}, "sweep");
  std::set<std::string> folders;
  std::vector<StepId> requested;
  for (const Variant& variant : swept_variants(sweep)) {
    folders.insert(variant.folder);
    for (const std::int64_t seed : tables.choice().seeds) {
      for (const std::string& ratio : ratios) {
        requested.push_back(
            tables.grid().diagnosis(dataset, seed, variant, ratio, sweep.classifier));
      }
      if (run::has_score(sweep.method)) tables.grid().score(dataset, seed, variant);
    }
  }
  const TableCells cells = tables.with_held(dataset, requested, [&](const HeldCell& cell) {
    return cell.kind == HeldCell::Kind::diagnosis && folders.contains(cell.variant.folder) &&
           cell.classifier == sweep.classifier;
  });
  const std::string name = run::sweep_name(sweep.method);
  Step step{.stage = "sweep",
            .folder = tables.folder_of(dataset),
            .log = name,
            .settings = tables.grid().settings().of(
                "sweep", sweep.method == augment::paper_method() ? "" : sweep.method),
            .words = {"--run", tables.grid().folder(), "--dataset", dataset.name},
            .outputs = in_folder(tables.folder_of(dataset), {name + ".csv", name + ".md"}),
            .place = {.dataset = dataset.name}};
  if (sweep.method != augment::paper_method()) step.options.emplace_back("method", sweep.method);
  if (!sweep.centre.empty()) step.options.emplace_back("centre", spaced(sweep.centre));
  append_option(step.words, "leave-out", cells.left_out);
  append_option(step.words, "ratios", ratios);
  append_option(step.words, "seeds", texts_of(tables.choice().seeds));
  tables.show(step.outputs.back());
  tables.add(std::move(step), "cells", cells.files);
}

}  // namespace

void add_sweeps(TableSteps& tables) {
  Words swept;
  for (const settings::Sweep& sweep : tables.experiment().sweeps) swept.push_back(sweep.method);
  if (swept.empty()) {
    throw Error(Exit::usage,
                "make sweep: [sweep] of pipeline/protocol.toml does not list a point; add one");
  }
  std::erase_if(swept,
                [&](const std::string& method) { return !has(tables.choice().methods, method); });
  if (swept.empty()) {
    Words all;
    for (const settings::Sweep& sweep : tables.experiment().sweeps) all.push_back(sweep.method);
    throw Error(
        Exit::usage,
        fmt::format(
            "make sweep: METHODS must include one of {}, because only their settings are moved",
            spaced(all)));
  }
  for (const Part& part : tables.choice().parts) {
    bool any = false;
    for (const settings::Sweep& sweep : tables.experiment().sweeps) {
      const bool fits = has(swept, sweep.method) &&
                        run::go_together(sweep.method, sweep.classifier, !part.dataset.any_known);
      if (fits) add_sweep(tables, part, sweep);
      any = any || fits;
    }
    if (any) continue;
    throw Error(Exit::usage, fmt::format("make sweep: {}: no fault window is known, but the sweeps "
                                         "of {} need some; choose other DATASETS or METHODS",
                                         part.dataset.name, spaced(swept)));
  }
}

}  // namespace piae::plan

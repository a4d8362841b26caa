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

const Words table_names{"accuracy.csv", "gains.csv",     "quality.csv",    "comparisons.csv",
                        "ranks.csv",    "decisions.csv", "confidence.csv", "recommendation.csv",
                        "tables.md",    "tables.tex",    "summary.txt"};

Words in_folder(const std::string& folder, const Words& names) {
  Words files;
  for (const std::string& name : names) files.push_back(fmt::format("{}/{}", folder, name));
  return files;
}

Words texts_of(const std::vector<std::int64_t>& seeds) {
  Words words;
  for (const std::int64_t seed : seeds) words.push_back(std::to_string(seed));
  return words;
}

std::string nothing_generated() { return scoring::all_ratios().front().name; }

/// The ratio at which a method has the most generated windows, among these.
std::string last_ratio(const std::string& method, const Words& ratios) {
  std::string last;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    if (has(ratios, ratio.name) && run::go_together(method, ratio)) last = ratio.name;
  }
  return last;
}

/// The tables that the paper publishes.
Words published(Disk& disk) {
  Words files;
  for (const std::string& name : disk.files_below("results/published")) {
    if (name.ends_with(".csv")) files.push_back("results/published/" + name);
  }
  if (files.empty()) {
    throw Error(Exit::input_missing,
                "results/published holds no table: what the paper publishes is shown beside our "
                "results; `git checkout results/published` brings it back");
  }
  return files;
}

}  // namespace

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

/// The topmost folder of which all is out of date, below that of the data set; or the file.
std::string TableSteps::name_of_left_out(const Dataset& dataset, const HeldCell& cell, StepId id) {
  const auto is_old = [&](StepId each) {
    const Verdict& verdict = judge_.of(each);
    return verdict.state != State::current && !verdict.only_missing;
  };
  std::string seed = "seed" + std::to_string(cell.seed);
  if (is_old(grid_.split(dataset, cell.seed))) return seed;
  const bool generates = cell.variant.method != augment::no_method;
  if (generates && is_old(grid_.windows(dataset, cell.seed, cell.variant))) {
    return seed + '/' + cell.variant.folder;
  }
  return grid_.graph().at(id).outputs.front().substr(folder_of(dataset).size() + 1);
}

TableCells TableSteps::with_held(const Dataset& dataset, const std::vector<StepId>& asked,
                                 const Chosen& chosen, bool only_looks) {
  TableCells cells;
  std::set<std::string> taken;
  const auto take = [&](const std::string& file) {
    if (taken.insert(file).second) cells.files.push_back(file);
  };
  for (const StepId id : asked) take(grid_.graph().at(id).outputs.front());
  std::set<std::string> left_out;
  Words old;
  grid_.ask(false);
  for (const HeldCell& cell : held(dataset)) {
    if (!chosen(cell)) continue;
    const StepId id = step_of(dataset, cell);
    const std::string file = grid_.graph().at(id).outputs.front();
    if (taken.contains(file)) continue;
    const Verdict& verdict = judge_.of(id);
    if (verdict.state == State::current || verdict.only_missing) {
      take(file);
    } else {
      left_out.insert(name_of_left_out(dataset, cell, id));
      old.push_back(file);
    }
  }
  grid_.ask(true);
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

/// The picture that gnuplot draws of a table.
void TableSteps::add_picture(const std::string& csv) {
  const std::string name = csv.substr(0, csv.size() - std::string(".csv").size());
  Words scripts;
  for (const std::string& script : disk_.files_below("pipeline/figures")) {
    scripts.push_back("pipeline/figures/" + script);
  }
  Step step{.stage = "draw",
            .folder = csv.substr(0, csv.rfind('/')),
            .log = name.substr(name.rfind('/') + 1),
            .inputs = {{.role = "scripts", .files = scripts, .is_option = false}},
            .outputs = {name + ".svg", name + ".pdf"}};
  add(std::move(step), "numbers", {csv});
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

/// Drops the cells that are missing; gives the options that name one of the rest, which a table
/// needs.
std::vector<StepId> TableSteps::without_holes(std::vector<StepId> asked, Words& one_cell) {
  std::erase_if(asked, [&](StepId id) { return judge_.of(id).state != State::current; });
  for (const StepId id : asked) {
    const Place& place = grid_.graph().at(id).place;
    if (place.ratio.empty()) continue;
    append_option(one_cell, "methods", {place.method});
    append_option(one_cell, "ratios", {place.ratio});
    append_option(one_cell, "seeds", {std::to_string(*place.seed)});
    append_option(one_cell, "classifiers", {place.classifier});
    break;
  }
  return asked;
}

void TableSteps::add_tables(const Part& part) {
  const Dataset& dataset = part.dataset;
  std::vector<StepId> asked = cells_of(part);
  Words selected = selection(part);
  if (choice_.with_holes) {
    selected.clear();
    asked = without_holes(std::move(asked), selected);
    if (selected.empty()) return;
  }
  const TableCells cells = with_held(dataset, asked, [&](const HeldCell& cell) {
    return cell.kind != HeldCell::Kind::model && cell.variant.folder == cell.variant.method;
  });
  Step step{.stage = "tabulate",
            .folder = folder_of(dataset),
            .settings = grid_.settings().of("tabulate"),
            .inputs = {input_of_published(disk_)},
            .words = {"--run", grid_.folder(), "--dataset", dataset.name},
            .outputs = in_folder(folder_of(dataset), table_names),
            .place = {.dataset = dataset.name}};
  append(step.words, selected);
  if (choice_.with_holes && !dataset.any_known) {
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

/// The ratios of a table of settings that are moved: those given, else `otherwise`.
Words TableSteps::moved_ratios(const Words& otherwise, const std::string& goal) const {
  Words ratios;
  for (const std::string& ratio : choice_.ratios_given ? choice_.ratios : otherwise) {
    if (ratio != nothing_generated()) ratios.push_back(ratio);
  }
  if (ratios.empty()) {
    throw Error(Exit::usage, fmt::format("make {}: RATIOS must have others than {}, at which "
                                         "nothing is generated",
                                         goal, nothing_generated()));
  }
  return ratios;
}

void TableSteps::add_sweep(const Part& part, const settings::Sweep& sweep) {
  const Dataset& dataset = part.dataset;
  const Words ratios = moved_ratios({"1to1"}, "sweep");
  std::vector<Variant> variants{variant_of(sweep.method)};
  std::set<std::string> folders{sweep.method};
  for (const std::string& point : sweep.points) {
    if (has(sweep.centre, point)) continue;
    variants.push_back({.folder = sweep_folder(sweep.method, point),
                        .method = sweep.method,
                        .moved = {*settings::parse_point(point)}});
    folders.insert(variants.back().folder);
  }
  std::vector<StepId> asked;
  for (const std::int64_t seed : choice_.seeds) {
    for (const Variant& variant : variants) {
      for (const std::string& ratio : ratios) {
        asked.push_back(grid_.diagnosis(dataset, seed, variant, ratio, sweep.classifier));
      }
      if (run::has_score(sweep.method)) grid_.score(dataset, seed, variant);
    }
  }
  const TableCells cells = with_held(dataset, asked, [&](const HeldCell& cell) {
    return cell.kind == HeldCell::Kind::diagnosis && folders.contains(cell.variant.folder) &&
           cell.classifier == sweep.classifier;
  });
  const std::string name = run::sweep_name(sweep.method);
  Step step{.stage = "sweep",
            .folder = folder_of(dataset),
            .log = name,
            .settings = grid_.settings().of(
                "sweep", sweep.method == augment::paper_method() ? "" : sweep.method),
            .words = {"--run", grid_.folder(), "--dataset", dataset.name},
            .outputs = in_folder(folder_of(dataset), {name + ".csv", name + ".md"}),
            .place = {.dataset = dataset.name}};
  if (sweep.method != augment::paper_method()) step.options.emplace_back("method", sweep.method);
  if (!sweep.centre.empty()) step.options.emplace_back("centre", spaced(sweep.centre));
  append_option(step.words, "leave-out", cells.left_out);
  append_option(step.words, "ratios", ratios);
  append_option(step.words, "seeds", texts_of(choice_.seeds));
  shown_.push_back(step.outputs.back());
  add(std::move(step), "cells", cells.files);
}

void TableSteps::sweep() {
  Words swept;
  for (const settings::Sweep& sweep : experiment_.sweeps) swept.push_back(sweep.method);
  if (swept.empty()) {
    throw Error(Exit::usage, "make sweep: no points in [sweep] of pipeline/protocol.toml");
  }
  std::erase_if(swept, [&](const std::string& method) { return !has(choice_.methods, method); });
  if (swept.empty()) {
    Words all;
    for (const settings::Sweep& sweep : experiment_.sweeps) all.push_back(sweep.method);
    throw Error(Exit::usage,
                fmt::format("make sweep moves the settings of {}: METHODS must have one of them",
                            spaced(all)));
  }
  for (const Part& part : choice_.parts) {
    bool any = false;
    for (const settings::Sweep& sweep : experiment_.sweeps) {
      const bool fits = has(swept, sweep.method) &&
                        run::go_together(sweep.method, sweep.classifier, !part.dataset.any_known);
      if (fits) add_sweep(part, sweep);
      any = any || fits;
    }
    if (any) continue;
    throw Error(Exit::usage, fmt::format("make sweep: {}: no fault window is known, and none of {} "
                                         "works there by the classifier of its sweep",
                                         part.dataset.name, spaced(swept)));
  }
}

void TableSteps::add_readings(const Part& part) {
  const Dataset& dataset = part.dataset;
  if (!part.dataset.any_known) {
    throw Error(Exit::usage, fmt::format("make readings: {}: no fault window is known, and {} "
                                         "learns from those",
                                         dataset.name, augment::paper_method()));
  }
  const Words ratios = moved_ratios({"10to1", "1to1"}, "readings");
  Words readings{"base"};
  append(readings, experiment_.readings);
  Words files;
  for (const std::int64_t seed : choice_.seeds) {
    for (const std::string& reading : readings) {
      const Variant variant{.folder = reading_folder(reading),
                            .method = augment::paper_method(),
                            .moved = settings_of_reading(experiment_, reading)};
      const auto take = [&](StepId id) { files.push_back(grid_.graph().at(id).outputs.front()); };
      take(grid_.score(dataset, seed, variant));
      for (const std::string& ratio : ratios) {
        take(grid_.diagnosis(dataset, seed, variant, ratio, scoring::paper_classifier));
      }
    }
  }
  const std::string folder = folder_of(dataset);
  Step step{.stage = "readings",
            .folder = folder,
            .settings = grid_.settings().of("readings"),
            .inputs = {input_of_published(disk_)},
            .options = {{"ratios", spaced(ratios)}, {"seeds", spaced(texts_of(choice_.seeds))}},
            .words = {"--run", grid_.folder(), "--dataset", dataset.name, "--published",
                      "results/published"},
            .outputs = in_folder(folder, {"readings.csv", "readings.md"}),
            .place = {.dataset = dataset.name}};
  shown_.push_back(step.outputs.back());
  add(std::move(step), "cells", files);
  add_picture(folder + "/readings.csv");
}

void TableSteps::readings() {
  if (experiment_.readings.empty()) {
    throw Error(Exit::usage, "make readings: [readings] of pipeline/protocol.toml names none");
  }
  for (const Part& part : choice_.parts) add_readings(part);
}

void TableSteps::add_identify(const Part& part) {
  const Dataset& dataset = part.dataset;
  std::vector<StepId> asked;
  Words methods;
  Words windows;
  for (const std::string& method : choice_.methods) {
    if (augment::find_entry(method)->infers) methods.push_back(method);
  }
  for (const std::int64_t seed : choice_.seeds) {
    for (const std::string& method : methods) {
      asked.push_back(grid_.model(dataset, seed, variant_of(method)));
    }
  }
  const TableCells models = with_held(dataset, asked, [&](const HeldCell& cell) {
    return cell.kind == HeldCell::Kind::model && cell.variant.folder == cell.variant.method &&
           augment::find_entry(cell.variant.method)->infers;
  });
  const std::string folder = folder_of(dataset);
  Step step{
      .stage = "identify",
      .folder = folder,
      .settings = grid_.settings().of("identify"),
      .words = {"--run", grid_.folder(), "--dataset", dataset.name},
      .outputs = in_folder(folder, {"identifiability.csv", "scatter.csv", "identifiability.md"}),
      .place = {.dataset = dataset.name}};
  append_option(step.words, "leave-out", models.left_out);
  append_option(step.words, "methods", methods);
  append_option(step.words, "seeds", texts_of(choice_.seeds));
  shown_.push_back(step.outputs.back());
  add(std::move(step), "models", models.files);
}

void TableSteps::identify() {
  const bool any_infers = std::ranges::any_of(choice_.methods, [](const std::string& method) {
    return augment::find_entry(method)->infers;
  });
  Words simulated;
  Words inferring;
  for (const Dataset& dataset : experiment_.datasets) {
    if (dataset.is_simulated && dataset.any_known) simulated.push_back(dataset.name);
  }
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (entry.infers) inferring.emplace_back(entry.name);
  }
  bool any = false;
  for (const Part& part : choice_.parts) {
    if (!has(simulated, part.dataset.name) || !any_infers) continue;
    add_identify(part);
    any = true;
  }
  if (!any_infers) {
    throw Error(Exit::usage, "make identify: METHODS must have one of " + spaced(inferring));
  }
  if (!any) {
    throw Error(Exit::usage, fmt::format("make identify: DATASETS must have one that is simulated "
                                         "({}), whose (k, c) are known",
                                         spaced(simulated)));
  }
}

void TableSteps::add_trust(const Part& part) {
  Words files;
  for (const std::int64_t seed : choice_.seeds) {
    for (const run::Combination& cell : part.cells) {
      const StepId id =
          grid_.classifier(part.dataset, seed, cell.method, cell.ratio, cell.classifier);
      files.push_back(grid_.graph().at(id).outputs.front());
    }
  }
  const std::string folder = folder_of(part.dataset);
  Step step{.stage = "trust",
            .folder = folder,
            .settings = grid_.settings().of("trust"),
            .words = {"--run", grid_.folder(), "--dataset", part.dataset.name},
            .outputs = in_folder(folder, {"trust.csv", "trust.md"}),
            .place = {.dataset = part.dataset.name}};
  append(step.words, selection(part));
  shown_.push_back(step.outputs.back());
  add(std::move(step), "classifiers", files);
}

void TableSteps::trust() {
  for (const Part& part : choice_.parts) add_trust(part);
}

std::vector<const Part*> TableSteps::parts_of(const settings::Group& group) const {
  std::vector<const Part*> parts;
  for (const std::string& name : group.datasets) {
    const auto found = std::ranges::find_if(
        choice_.parts, [&](const Part& part) { return part.dataset.name == name; });
    if (found != choice_.parts.end()) parts.push_back(&*found);
  }
  return parts;
}

void TableSteps::add_transfer(const settings::Group& group) {
  const std::string ratio = [&] {
    std::string last;
    for (const scoring::Ratio& each : scoring::all_ratios()) {
      if (each.generated_per_class > 0 && has(choice_.ratios, each.name)) last = each.name;
    }
    return last;
  }();
  if (ratio.empty()) {
    throw Error(Exit::usage, fmt::format("make transfer: RATIOS must have others than {}, at which "
                                         "nothing is generated",
                                         nothing_generated()));
  }
  std::set<std::string> lacks;
  for (const Words& inputs : {group.inputs, group.kind_inputs}) {
    for (const std::string& input : inputs) {
      const std::size_t equals = input.find('=');
      const bool is_needed = has(choice_.methods, input.substr(0, equals)) &&
                             !has(choice_.classifiers, input.substr(equals + 1));
      if (is_needed) lacks.insert(input.substr(equals + 1));
    }
  }
  if (!lacks.empty()) {
    throw Error(Exit::usage,
                fmt::format("make transfer: CLASSIFIERS must have {}, which [transfer.{}] of "
                            "pipeline/protocol.toml names for these METHODS",
                            fmt::join(lacks, " "), group.name));
  }
  Words files;
  for (const Part* part : parts_of(group)) {
    for (const StepId id : cells_of(*part)) {
      const Step& step = grid_.graph().at(id);
      const bool counts = step.place.ratio == nothing_generated() || step.place.ratio == ratio;
      if (counts) files.push_back(step.outputs.front());
    }
  }
  const std::string name = "transfer@" + group.name;
  Step step{.stage = "transfer",
            .folder = grid_.folder(),
            .log = name,
            .settings = grid_.settings().of("transfer", group.name),
            .options = {{"group", group.name},
                        {"methods", spaced(choice_.methods)},
                        {"ratio", ratio},
                        {"classifiers", spaced(choice_.classifiers)},
                        {"seeds", spaced(texts_of(choice_.seeds))}},
            .words = {"--run", grid_.folder()},
            .outputs = in_folder(
                grid_.folder(),
                {name + ".csv", "transfer-comparisons@" + group.name + ".csv", name + ".md"})};
  shown_.push_back(step.outputs.back());
  add(std::move(step), "cells", files);
  add_picture(grid_.folder() + '/' + name + ".csv");
}

void TableSteps::transfer() {
  bool any = false;
  Words groups;
  for (const settings::Group& group : experiment_.groups) {
    Words there;
    for (const std::string& dataset : group.datasets) {
      if (experiment_.find(dataset) != nullptr) there.push_back(dataset);
    }
    groups.push_back(fmt::format("{} ({})", group.name, spaced(there)));
    if (parts_of(group).size() < there.size()) continue;
    settings::require_datasets(experiment_.protocol, group.name, experiment_.pipeline);
    add_transfer(group);
    any = true;
  }
  if (any) return;
  throw Error(Exit::usage,
              fmt::format("make transfer: DATASETS must have all of a group: {}", spaced(groups)));
}

}  // namespace piae::plan

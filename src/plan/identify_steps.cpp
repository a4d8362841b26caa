#include "plan/identify_steps.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "plan/words.hpp"

namespace piae::plan {

namespace {

void add_identification(TableSteps& tables, const Part& part) {
  const Dataset& dataset = part.dataset;
  std::vector<StepId> requested;
  Words methods;
  for (const std::string& method : tables.choice().methods) {
    if (augment::find_entry(method)->infers) methods.push_back(method);
  }
  for (const std::int64_t seed : tables.choice().seeds) {
    for (const std::string& method : methods) {
      requested.push_back(tables.grid().model(dataset, seed, variant_of(method)));
    }
  }
  const TableCells models = tables.with_held(dataset, requested, [&](const HeldCell& cell) {
    return cell.kind == HeldCell::Kind::model && cell.variant.folder == cell.variant.method &&
           augment::find_entry(cell.variant.method)->infers;
  });
  const std::string folder = tables.folder_of(dataset);
  Step step{
      .stage = "identify",
      .folder = folder,
      .settings = tables.grid().settings().of("identify"),
      .words = {"--run", tables.grid().folder(), "--dataset", dataset.name},
      .outputs = in_folder(folder, {"identifiability.csv", "scatter.csv", "identifiability.md"}),
      .place = {.dataset = dataset.name}};
  append_option(step.words, "leave-out", models.left_out);
  append_option(step.words, "methods", methods);
  append_option(step.words, "seeds", texts_of(tables.choice().seeds));
  tables.show(step.outputs.back());
  tables.add(std::move(step), "models", models.files);
}

}  // namespace

void add_identifications(TableSteps& tables) {
  const bool any_infers = std::ranges::any_of(
      tables.choice().methods,
      [](const std::string& method) { return augment::find_entry(method)->infers; });
  Words simulated;
  Words inferring;
  for (const Dataset& dataset : tables.experiment().datasets) {
    if (dataset.is_simulated && dataset.any_known) simulated.push_back(dataset.name);
  }
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (entry.infers) inferring.emplace_back(entry.name);
  }
  bool any = false;
  for (const Part& part : tables.choice().parts) {
    if (!has(simulated, part.dataset.name) || !any_infers) continue;
    add_identification(tables, part);
    any = true;
  }
  if (!any_infers) {
    throw Error(Exit::usage, "make identify: METHODS must include one of " + spaced(inferring));
  }
  if (!any) {
    throw Error(Exit::usage, fmt::format("make identify: DATASETS must include a simulated one "
                                         "({}), because only simulated (k, c) are known",
                                         spaced(simulated)));
  }
}

}  // namespace piae::plan

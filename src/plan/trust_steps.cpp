#include "plan/trust_steps.hpp"

#include "plan/words.hpp"
#include "run/layout.hpp"

namespace piae::plan {

namespace {

void add_trust_of(TableSteps& tables, const Part& part) {
  const Words files = tables.add_for_cells(part, &GridSteps::classifier);
  const std::string folder = tables.folder_of(part.dataset);
  Step step{.stage = "trust",
            .folder = folder,
            .settings = tables.grid().settings().of("trust"),
            .words = {"--run", tables.grid().folder(), "--dataset", part.dataset.name},
            .outputs = in_folder(folder, {"trust.csv", "trust.md"}),
            .place = {.dataset = part.dataset.name}};
  append(step.words, tables.selection(part));
  tables.show(step.outputs.back());
  tables.add(std::move(step), "classifiers", files);
}

}  // namespace

void add_trust(TableSteps& tables) {
  for (const Part& part : tables.choice().parts) add_trust_of(tables, part);
}

}  // namespace piae::plan

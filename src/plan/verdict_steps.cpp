#include "plan/verdict_steps.hpp"

#include "plan/words.hpp"
#include "run/layout.hpp"

namespace piae::plan {

namespace {

void add_verdicts_of(TableSteps& tables, const Part& part) {
  const Words files = tables.add_for_cells(part, &GridSteps::classification);
  const std::string folder = tables.folder_of(part.dataset);
  Step step{.stage = "verdicts",
            .folder = folder,
            .words = {"--run", tables.grid().folder(), "--dataset", part.dataset.name},
            .outputs = in_folder(folder, {"verdicts.csv", "verdicts.md"}),
            .place = {.dataset = part.dataset.name}};
  append(step.words, tables.selection(part));
  const std::string of_others =
      (tables.experiment().pipeline / "datasets" / (part.dataset.name + ".csv")).string();
  if (tables.disk().find(of_others) != nullptr) {
    step.inputs.push_back({.role = "others", .files = {of_others}});
  }
  tables.show(step.outputs.back());
  tables.add(std::move(step), "verdicts", files);
  tables.add_picture(folder + "/verdicts.csv");
}

}  // namespace

void add_verdicts(TableSteps& tables) {
  for (const Part& part : tables.choice().parts) add_verdicts_of(tables, part);
}

}  // namespace piae::plan

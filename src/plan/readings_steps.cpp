#include "plan/readings_steps.hpp"

#include <spdlog/fmt/fmt.h>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "plan/words.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::plan {

namespace {

void add_readings_of(TableSteps& tables, const Part& part) {
  const Dataset& dataset = part.dataset;
  if (!part.dataset.any_known) {
    throw Error(Exit::usage, fmt::format("make readings: {}: no fault window is known, but {} "
                                         "learns from such windows; choose other DATASETS",
                                         dataset.name, augment::paper_method()));
  }
  const Words ratios = tables.moved_ratios({"10to1", "1to1"}, "readings");
  Words readings{"base"};
  append(readings, tables.experiment().readings);
  Words files;
  for (const std::int64_t seed : tables.choice().seeds) {
    for (const std::string& reading : readings) {
      const Variant variant{.folder = reading_folder(reading),
                            .method = augment::paper_method(),
                            .moved = settings_of_reading(tables.experiment(), reading)};
      const auto take = [&](StepId id) {
        files.push_back(tables.grid().graph().at(id).outputs.front());
      };
      take(tables.grid().score(dataset, seed, variant));
      for (const std::string& ratio : ratios) {
        take(tables.grid().diagnosis(dataset, seed, variant, ratio, scoring::paper_classifier));
      }
    }
  }
  const std::string folder = tables.folder_of(dataset);
  Step step{
      .stage = "readings",
      .folder = folder,
      .settings = tables.grid().settings().of("readings"),
      .inputs = {input_of_published(tables.disk())},
      .options = {{"ratios", spaced(ratios)}, {"seeds", spaced(texts_of(tables.choice().seeds))}},
      .words = {"--run", tables.grid().folder(), "--dataset", dataset.name, "--published",
                "results/published"},
      .outputs = in_folder(folder, {"readings.csv", "readings.md"}),
      .place = {.dataset = dataset.name}};
  tables.show(step.outputs.back());
  tables.add(std::move(step), "cells", files);
  tables.add_picture(folder + "/readings.csv");
}

}  // namespace

void add_readings(TableSteps& tables) {
  if (tables.experiment().readings.empty()) {
    throw Error(Exit::usage,
                "make readings: [readings] of pipeline/protocol.toml does not list an "
                "interpretation; add one");
  }
  for (const Part& part : tables.choice().parts) add_readings_of(tables, part);
}

}  // namespace piae::plan

#include "plan/look_steps.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>

#include "base/error.hpp"
#include "plan/words.hpp"

namespace piae::plan {

namespace {

bool is_artefact_or_table(const std::string& file) {
  const auto ends = [&](const char* ending) { return file.ends_with(ending); };
  return (file.starts_with("seed") && ends(".h5")) || ends("scatter.csv") ||
         ends("identifiability.csv") || (file.starts_with("sweep") && ends(".csv"));
}

/// Returns the options of a command line, each with its values.
std::vector<std::pair<std::string, std::string>> options_in(const Words& words) {
  std::vector<std::pair<std::string, std::string>> options;
  for (const std::string& word : words) {
    if (word.starts_with("--")) {
      options.emplace_back(word.substr(2), "");
    } else {
      std::string& values = options.back().second;
      values += (values.empty() ? "" : " ") + word;
    }
  }
  return options;
}

}  // namespace

Words LookSteps::left_out(const Dataset& dataset) {
  return tables_
      .with_held(
          dataset, {},
          [](const HeldCell& cell) {
            return cell.kind != HeldCell::Kind::model && cell.variant.folder == cell.variant.method;
          },
          true)
      .left_out;
}

Words LookSteps::must_be_there(const Part& part) const {
  return choice_.only_looks ? choice_.given : tables_.selection(part);
}

void LookSteps::numbers() {
  bool any = false;
  for (const Part& part : choice_.parts) {
    const Dataset& dataset = part.dataset;
    const std::string folder = grid_.folder() + '/' + dataset.name;
    Words files;
    for (const std::string& file : tables_.disk().files_below(folder)) {
      if (is_artefact_or_table(file)) files.push_back(fmt::format("{}/{}", folder, file));
    }
    if (files.empty()) continue;
    any = true;
    const std::string blocked = choice_.folder_of(signal::Protocol::blocked) + '/' + dataset.name;
    if (choice_.protocol == signal::Protocol::random) {
      for (const std::string& file : tables_.disk().files_below(blocked)) {
        if (file.ends_with("diagnosis.h5")) files.push_back(fmt::format("{}/{}", blocked, file));
      }
    }
    Step step{.stage = "figures",
              .folder = folder,
              .inputs = {input_of_published(tables_.disk()),
                         {.role = "costs", .files = {"jobs/costs.csv"}}},
              .words = {"--run", grid_.folder(), "--dataset", dataset.name},
              .place = {.dataset = dataset.name},
              .tables_folder = folder + "/figures"};
    // Figures that lack a mandatory cell are removed, so the list of mandatory cells is an option.
    // With the goal `all` every possible cell exists.
    const bool only_figures =
        choice_.has_goal("figures") && !choice_.has_goal("all") && !choice_.only_pictures;
    if (only_figures) step.options = options_in(must_be_there(part));
    if (!dataset.any_known && !only_figures) {
      append(step.words, {"--nothing-known", dataset.name});
    }
    const Words old = left_out(dataset);
    if (!old.empty())
      step.options.emplace_back("leave-out", fmt::format("{}", fmt::join(old, " ")));
    append(step.words, {"--published", "results/published"});
    tables_.add(std::move(step), "cells", files);
  }
  if (any || !choice_.only_looks) return;
  Words names;
  for (const Part& part : choice_.parts) names.push_back(part.dataset.name);
  throw Error(Exit::input_missing,
              fmt::format("{} holds no cell of {}", grid_.folder(), fmt::join(names, " ")));
}

void LookSteps::pictures() {
  for (const Part& part : choice_.parts) {
    const std::string folder = grid_.folder() + '/' + part.dataset.name + "/figures";
    for (const std::string& file : tables_.disk().files_below(folder)) {
      if (file.ends_with(".csv")) tables_.add_picture(fmt::format("{}/{}", folder, file));
    }
  }
}

void LookSteps::pages(const Experiment& experiment) {
  Step step{.stage = "report",
            .folder = grid_.folder(),
            .log = "report",
            .words = {"--run", grid_.folder()},
            .outputs = {grid_.folder() + "/report.html", grid_.folder() + "/report.md",
                        grid_.folder() + "/run.html"},
            .is_artefact = false,
            .is_always_due = true};
  Words datasets;
  Words old;
  for (const Part& part : choice_.parts) {
    datasets.push_back(part.dataset.name);
    for (const std::string& file : left_out(part.dataset)) {
      old.push_back(part.dataset.name + '/' + file);
    }
  }
  if (!choice_.only_looks) append_option(step.words, "datasets", datasets);
  append(step.words, choice_.only_looks ? choice_.given : tables_.whole_selection());
  append(step.words, {"--published", "results/published"});
  for (const Dataset& dataset : experiment.datasets) {
    if (!dataset.any_known) append(step.words, {"--nothing-known", dataset.name});
  }
  append_option(step.words, "leave-out", old);
  grid_.graph().add(std::move(step));
}

}  // namespace piae::plan

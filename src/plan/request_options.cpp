#include "plan/request_options.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "plan/words.hpp"

namespace piae::plan {

namespace fs = std::filesystem;

namespace {

std::optional<std::string> if_given(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

/// Returns the data sets that have a seed in the folder of a run.
std::vector<std::string> held_in(const fs::path& run) {
  std::vector<std::string> held;
  std::error_code none;
  for (const fs::directory_entry& dataset : fs::directory_iterator(run, none)) {
    if (!dataset.is_directory(none)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(dataset.path(), none)) {
      if (!entry.path().filename().string().starts_with("seed")) continue;
      held.push_back(dataset.path().filename());
      break;
    }
  }
  std::ranges::sort(held);
  return held;
}

}  // namespace

void bind(const cli::Options& command, RequestOptions& requested) {
  command.add("--goals", requested.goals, "Goals, such as all or cells, or files of a run")
      .from_environment("GOALS");
  command.add("--run", requested.run, "Folder under results/").from_environment("RUN");
  command.add("--datasets", requested.datasets, "Data sets").from_environment("DATASETS");
  command.add("--methods", requested.methods, "Methods; paper: the methods of the paper")
      .from_environment("METHODS");
  command.add("--ratios", requested.ratios, "Ratios of known to generated windows")
      .from_environment("RATIOS");
  command.add("--classifiers", requested.classifiers, "Classifiers")
      .from_environment("CLASSIFIERS");
  command.add("--seeds", requested.seeds, "Independent repeats").from_environment("SEEDS");
  command
      .choose("--protocol", requested.protocol, signal::protocol_words(),
              "Split: random (the paper) or blocked (no overlaps)")
      .from_environment("PROTOCOL");
  command.add("--data-dir", requested.data_dir, "Folder of the recordings")
      .from_environment("DATA_DIR");
}

void bind(const cli::Options& command, PlanOptions& options) {
  command.add("--pipeline", options.pipeline, "Folder with protocol.toml and datasets/");
  std::vector<cli::Word<Stretch>> words;
  words.reserve(stretches.size());
  for (const Stretch stretch : stretches) words.push_back({to_string(stretch), stretch});
  command
      .choose("--stretch", options.stretch, words,
              "First part of the run to consider; a makefile covers the first one from there on "
              "with due steps")
      .from_environment("PIAE_STRETCH");
  command
      .flag("--with-holes", options.with_missing,
            "Make tables from the existing cells even if others are missing")
      .from_environment("PIAE_WITH_HOLES");
  command.flag("--looks", options.looks, "Write nothing, not even settings files and the journal");
  command.add("--only", options.only,
              "Plan only the files listed in this file, one a line, and what they need");
}

Request RequestOptions::request() const {
  Request request;
  if (!goals.empty()) {
    request.goals = words_in(goals);
  }
  if (!run.empty()) request.run = run;
  request.datasets = if_given(datasets);
  request.methods = if_given(methods);
  request.ratios = if_given(ratios);
  request.classifiers = if_given(classifiers);
  request.seeds = if_given(seeds);
  request.protocol = protocol;
  if (!data_dir.empty()) request.data_dir = data_dir;
  const std::string suffix = protocol == signal::Protocol::blocked ? "-blocked" : "";
  request.held = held_in("results/" + request.run + suffix);
  return request;
}

}  // namespace piae::plan

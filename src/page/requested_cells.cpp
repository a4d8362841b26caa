#include "page/requested_cells.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "base/error.hpp"
#include "scoring/ratios.hpp"

namespace piae::page {

namespace fs = std::filesystem;

namespace {

/// Returns the names of the folders in a folder.
std::vector<std::string> folders_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code none_there;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none_there)) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> requested_datasets(const RequestedCells& requested) {
  if (requested.datasets.empty()) return {};
  return run::split_list("--datasets", requested.datasets);
}

/// True if only `make identify` left the models of this dataset.
bool was_only_identified(const run::Started& started) {
  return fs::is_regular_file(started.layout().identifiability_csv()) && !started.has_cells();
}

/// True if the report includes a data set that the user did not name. Warns about a data set that
/// was tried but has no started method: nothing records which of its cells are missing.
bool is_reported(const run::Started& started) {
  if (!started.methods().empty()) return !was_only_identified(started);
  const fs::path folder = started.layout().folder();
  if (!started.seeds().empty() || fs::exists(folder / "ingest.log")) {
    spdlog::warn(
        "{}: no method was started, so the report leaves it out; name it in --datasets to include "
        "it",
        folder.string());
  }
  return false;
}

std::vector<std::string> every_ratio() {
  std::vector<std::string> names;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) names.emplace_back(ratio.name);
  return names;
}

}  // namespace

void bind(const cli::Options& command, RequestedCells& requested) {
  command.add("--datasets", requested.datasets,
              "Data sets, such as: cwru hit-sm; default: those in the folder");
  run::bind_started_cells(command, requested.cells);
  command.add("--leave-out", requested.leave_out,
              "Stale files and folders to leave out of the report, such as cwru/seed1/smote");
}

std::vector<std::string> RequestedCells::left_out_of(const std::string& dataset) const {
  std::vector<std::string> names;
  for (const std::string& name : leave_out) {
    if (name.starts_with(dataset + "/")) names.push_back(name.substr(dataset.size() + 1));
  }
  return names;
}

std::vector<std::string> datasets_of(const fs::path& run, const RequestedCells& requested) {
  std::vector<std::string> datasets = requested_datasets(requested);
  for (const std::string& name : folders_in(run)) {
    const bool is_named = std::ranges::count(datasets, name) != 0;
    if (!is_named && is_reported(run::Started(run::Layout(run, name)))) datasets.push_back(name);
  }
  std::ranges::sort(datasets);
  if (datasets.empty()) {
    throw Error(Exit::input_missing,
                run.string() + ": holds no cell of any data set; run `make cells`");
  }
  return datasets;
}

run::Grid grid_of(const run::Started& started, const std::string& dataset,
                  const RequestedCells& requested) {
  const std::vector<std::string> datasets = requested_datasets(requested);
  if (!datasets.empty() && std::ranges::count(datasets, dataset) == 0) {
    return {.dataset = dataset, .scored = {}, .combinations = {}, .seeds = {}};
  }
  run::GridOptions cells = requested.cells;
  cells.dataset = dataset;
  // Without a started cell, no folder records the requested ratios.
  if (cells.ratios.empty() && !started.has_cells()) {
    cells.ratios = every_ratio();
  }
  return started.resolve(cells);
}

}  // namespace piae::page

#include "page/asked.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "run/begun.hpp"

namespace piae::page {

namespace fs = std::filesystem;

namespace {

/// Names of the folders in a folder.
std::vector<std::string> folders_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code none_there;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none_there)) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> asked_datasets(const AskedCells& asked) {
  if (asked.datasets.empty()) return {};
  return run::split_list("--datasets", asked.datasets);
}

}  // namespace

void bind(const cli::Options& command, AskedCells& asked) {
  command.add("--datasets", asked.datasets,
              "Data sets, such as: cwru hit-sm; those that the folder holds where it is not given");
  run::bind_begun_cells(command, asked.cells);
  command.add("--leave-out", asked.leave_out,
              "Files and folders that are out of date and not asked for, such as "
              "cwru/seed1/smote: the report is made without them");
}

std::vector<std::string> AskedCells::left_out_of(const std::string& dataset) const {
  std::vector<std::string> names;
  for (const std::string& name : leave_out) {
    if (name.starts_with(dataset + "/")) names.push_back(name.substr(dataset.size() + 1));
  }
  return names;
}

std::vector<std::string> datasets_of(const fs::path& run, const AskedCells& asked) {
  std::vector<std::string> datasets = folders_in(run);
  std::erase_if(datasets,
                [&](const std::string& name) { return !run::holds_cells(run::Layout(run, name)); });
  for (const std::string& name : asked_datasets(asked)) {
    if (std::ranges::count(datasets, name) == 0) datasets.push_back(name);
  }
  std::ranges::sort(datasets);
  if (datasets.empty()) {
    throw Error(Exit::input_missing,
                run.string() + ": holds no cell of any data set; `make cells` makes some");
  }
  return datasets;
}

run::Grid grid_of(const run::Layout& layout, const std::string& dataset, const AskedCells& asked) {
  const std::vector<std::string> datasets = asked_datasets(asked);
  if (!datasets.empty() && std::ranges::count(datasets, dataset) == 0) {
    return {.dataset = dataset, .scored = {}, .combinations = {}, .seeds = {}};
  }
  run::GridOptions cells = asked.cells;
  cells.dataset = dataset;
  return run::resolve_begun(layout, cells);
}

}  // namespace piae::page

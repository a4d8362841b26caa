#include "page/asked.hpp"

#include <algorithm>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "scoring/ratios.hpp"

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

bool is_in_any_seed(const run::Layout& layout, const fs::path& below) {
  return std::ranges::any_of(layout.seeds(), [&](std::int64_t seed) {
    return fs::is_directory(layout.folder() / ("seed" + std::to_string(seed)) / below);
  });
}

std::vector<std::string> methods_begun(const run::Layout& layout) {
  std::vector<std::string> methods;
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (is_in_any_seed(layout, entry.name)) methods.emplace_back(entry.name);
  }
  return methods;
}

std::vector<std::string> ratios_begun(const run::Layout& layout,
                                      const std::vector<std::string>& methods) {
  std::vector<std::string> ratios;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    const bool begun = std::ranges::any_of(methods, [&](const std::string& method) {
      return is_in_any_seed(layout, fs::path(method) / ratio.name);
    });
    if (begun) ratios.emplace_back(ratio.name);
  }
  return ratios;
}

}  // namespace

void bind(const cli::Options& command, AskedCells& asked) {
  const std::string held = "; those that the folder holds where it is not given";
  command.add("--datasets", asked.datasets, "Data sets, such as: cwru hit-sm" + held);
  command.add("--methods", asked.methods, "Methods, such as: none piae-dt" + held);
  command.add("--ratios", asked.ratios, "Ratios, such as: 100to1 10to1" + held);
  command.add("--seeds", asked.seeds, "Seeds, such as: 0 1 2" + held);
}

std::vector<std::string> datasets_of(const fs::path& run, const AskedCells& asked) {
  if (!asked.datasets.empty()) return run::split_list("--datasets", asked.datasets);
  std::vector<std::string> datasets = folders_in(run);
  std::erase_if(datasets,
                [&](const std::string& name) { return run::Layout(run, name).seeds().empty(); });
  if (datasets.empty()) {
    throw Error(Exit::input_missing,
                run.string() + ": holds no seed of any data set; `make cells` makes some");
  }
  return datasets;
}

run::Grid grid_of(const run::Layout& layout, const std::string& dataset, const AskedCells& asked) {
  run::GridOptions options{dataset, asked.methods, asked.ratios, asked.seeds};
  if (options.methods.empty()) options.methods = methods_begun(layout);
  if (options.ratios.empty()) options.ratios = ratios_begun(layout, options.methods);
  if (options.seeds.empty()) {
    for (const std::int64_t seed : layout.seeds()) options.seeds.push_back(std::to_string(seed));
  }
  if (options.methods.empty() || options.ratios.empty() || options.seeds.empty()) {
    throw Error(Exit::input_missing,
                layout.folder().string() +
                    ": holds no cell; say which there should be, by --methods, --ratios and "
                    "--seeds");
  }
  return run::resolve(options);
}

}  // namespace piae::page

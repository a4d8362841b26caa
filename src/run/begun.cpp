#include "run/begun.hpp"

#include <algorithm>
#include <filesystem>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "scoring/ratios.hpp"

namespace piae::run {

namespace fs = std::filesystem;

namespace {

bool is_in_any_seed(const Layout& layout, const fs::path& below) {
  return std::ranges::any_of(layout.seeds(), [&](std::int64_t seed) {
    return fs::is_directory(layout.folder() / ("seed" + std::to_string(seed)) / below);
  });
}

std::vector<std::string> methods_begun(const Layout& layout) {
  std::vector<std::string> methods;
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (is_in_any_seed(layout, entry.name)) methods.emplace_back(entry.name);
  }
  return methods;
}

std::vector<std::string> ratios_begun(const Layout& layout,
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

void bind_begun_cells(const cli::Options& command, std::vector<std::string>& methods,
                      std::vector<std::string>& ratios, std::vector<std::string>& seeds) {
  const std::string held = "; those that the folder holds where it is not given";
  command.add("--methods", methods, "Methods, such as: none piae-dt" + held);
  command.add("--ratios", ratios, "Ratios, such as: 100to1 10to1" + held);
  command.add("--seeds", seeds, "Seeds, such as: 0 1 2" + held);
}

Grid resolve_begun(const Layout& layout, GridOptions options) {
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
  return resolve(options);
}

}  // namespace piae::run

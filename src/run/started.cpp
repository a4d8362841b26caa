#include "run/started.hpp"

#include <algorithm>
#include <filesystem>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "diagnosis/catalogue.hpp"
#include "scoring/ratios.hpp"

namespace piae::run {

namespace fs = std::filesystem;

namespace {

bool is_in_any_seed(const Layout& layout, const fs::path& below) {
  return std::ranges::any_of(layout.seeds(), [&](std::int64_t seed) {
    return fs::is_directory(layout.folder() / ("seed" + std::to_string(seed)) / below);
  });
}

std::vector<std::string> ratios_started(const Layout& layout,
                                        const std::vector<std::string>& methods) {
  std::vector<std::string> ratios;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    const bool started = std::ranges::any_of(methods, [&](const std::string& method) {
      return is_in_any_seed(layout, fs::path(method) / ratio.name);
    });
    if (started) ratios.emplace_back(ratio.name);
  }
  return ratios;
}

/// True if the cell exists or its step has started. Its folder alone does not count: `make trust`
/// keeps classifiers there without a diagnosis.
bool is_cell_started(const Layout& layout, const std::string& method, const std::string& ratio,
                     std::int64_t seed, const std::string& classifier) {
  const fs::path cell = layout.diagnosis(method, ratio, seed, classifier);
  return fs::is_regular_file(cell) || fs::is_regular_file(cell.parent_path() / "diagnose.log");
}

bool is_started(const Layout& layout, const std::string& method, const std::string& classifier) {
  return std::ranges::any_of(scoring::all_ratios(), [&](const scoring::Ratio& ratio) {
    return std::ranges::any_of(layout.seeds(), [&](std::int64_t seed) {
      return is_cell_started(layout, method, ratio.name, seed, classifier);
    });
  });
}

/// Returns the classifiers with started cells. The cell of `none` by reference_classifier does not
/// count, because naming any classifier adds it. Returns an empty list if no classifier was ever
/// named.
std::vector<std::string> classifiers_started(const Layout& layout,
                                             const std::vector<std::string>& methods) {
  std::vector<std::string> started;
  for (const diagnosis::Classifier& each : diagnosis::classifiers()) {
    const std::string name = each.name;
    const bool any = std::ranges::any_of(methods, [&](const std::string& method) {
      const bool is_reference =
          method == augment::no_method && name == diagnosis::reference_classifier;
      return !is_reference && is_started(layout, method, name);
    });
    if (any) started.push_back(name);
  }
  const bool has_others = std::ranges::any_of(
      started, [](const std::string& name) { return name != scoring::paper_classifier; });
  if (has_others) return started;
  const bool has_reference =
      is_started(layout, augment::no_method, diagnosis::reference_classifier);
  return has_reference ? std::vector<std::string>{scoring::paper_classifier}
                       : std::vector<std::string>{};
}

}  // namespace

void bind_started_cells(const cli::Options& command, GridOptions& options) {
  const std::string held = "default: those in the folder";
  command.add("--methods", options.methods, "Methods, such as: none piae-dt; " + held);
  command.add("--ratios", options.ratios, "Ratios, such as: 100to1 10to1; " + held);
  command.add("--seeds", options.seeds, "Seeds, such as: 0 1 2; " + held);
  bind_classifiers(command, options.classifiers, held);
  bind_nothing_known(command, options.nothing_known);
}

std::vector<std::string> methods_started(const Layout& layout) {
  std::vector<std::string> methods;
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (is_in_any_seed(layout, entry.name)) methods.emplace_back(entry.name);
  }
  return methods;
}

bool holds_cells(const Layout& layout) {
  return !ratios_started(layout, methods_started(layout)).empty();
}

Grid resolve_started(const Layout& layout, GridOptions options) {
  if (options.methods.empty()) options.methods = methods_started(layout);
  if (options.ratios.empty()) options.ratios = ratios_started(layout, options.methods);
  if (options.classifiers.empty()) {
    options.classifiers = classifiers_started(layout, options.methods);
  }
  if (options.seeds.empty()) {
    for (const std::int64_t seed : layout.seeds()) options.seeds.push_back(std::to_string(seed));
  }
  if (options.methods.empty() || options.ratios.empty() || options.seeds.empty()) {
    throw Error(Exit::input_missing,
                layout.folder().string() +
                    ": holds no cell; name the cells by --methods, --ratios and --seeds");
  }
  return resolve(options);
}

}  // namespace piae::run

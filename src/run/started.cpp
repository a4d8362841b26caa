#include "run/started.hpp"

#include <algorithm>
#include <filesystem>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "diagnosis/catalogue.hpp"
#include "scoring/ratios.hpp"

namespace piae::run {

namespace fs = std::filesystem;

Started::Started(Layout layout) : layout_(std::move(layout)), seeds_(layout_.seeds()) {
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (is_in_any_seed(entry.name)) methods_.emplace_back(entry.name);
  }
}

bool Started::is_in_any_seed(const fs::path& below) const {
  return std::ranges::any_of(seeds_, [&](std::int64_t seed) {
    return fs::is_directory(layout_.folder() / ("seed" + std::to_string(seed)) / below);
  });
}

std::vector<std::string> Started::ratios_of(const std::vector<std::string>& methods) const {
  std::vector<std::string> ratios;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    const bool started = std::ranges::any_of(methods, [&](const std::string& method) {
      return is_in_any_seed(fs::path(method) / ratio.name);
    });
    if (started) ratios.emplace_back(ratio.name);
  }
  return ratios;
}

bool Started::is_cell_started(const CellName& cell) const {
  const fs::path file = layout_.diagnosis(cell.method, cell.ratio, cell.seed, cell.classifier);
  return fs::is_regular_file(file) || fs::is_regular_file(file.parent_path() / "diagnose.log");
}

bool Started::has_cells_by(const std::string& method, const std::string& classifier) const {
  return std::ranges::any_of(scoring::all_ratios(), [&](const scoring::Ratio& ratio) {
    return std::ranges::any_of(seeds_, [&](std::int64_t seed) {
      return is_cell_started({method, ratio.name, seed, classifier});
    });
  });
}

std::vector<std::string> Started::classifiers_of(const std::vector<std::string>& methods) const {
  std::vector<std::string> started;
  for (const diagnosis::Classifier& each : diagnosis::classifiers()) {
    const std::string name = each.name;
    const bool any = std::ranges::any_of(methods, [&](const std::string& method) {
      const bool is_reference =
          method == augment::no_method && name == diagnosis::reference_classifier;
      return !is_reference && has_cells_by(method, name);
    });
    if (any) started.push_back(name);
  }
  const bool has_others = std::ranges::any_of(
      started, [](const std::string& name) { return name != scoring::paper_classifier; });
  if (has_others) return started;
  const bool has_reference = has_cells_by(augment::no_method, diagnosis::reference_classifier);
  return has_reference ? std::vector<std::string>{scoring::paper_classifier}
                       : std::vector<std::string>{};
}

void bind_started_cells(const cli::Options& command, GridOptions& options) {
  const std::string held = "default: those in the folder";
  command.add("--methods", options.methods, "Methods, such as: none piae-dt; " + held);
  command.add("--ratios", options.ratios, "Ratios, such as: 100to1 10to1; " + held);
  command.add("--seeds", options.seeds, "Seeds, such as: 0 1 2; " + held);
  bind_classifiers(command, options.classifiers, held);
  bind_nothing_known(command, options.nothing_known);
}

Grid Started::resolve(GridOptions options) const {
  if (options.methods.empty()) options.methods = methods_;
  if (options.ratios.empty()) options.ratios = ratios_of(options.methods);
  if (options.classifiers.empty()) options.classifiers = classifiers_of(options.methods);
  if (options.seeds.empty()) {
    for (const std::int64_t seed : seeds_) options.seeds.push_back(std::to_string(seed));
  }
  if (options.methods.empty() || options.ratios.empty() || options.seeds.empty()) {
    throw Error(Exit::input_missing,
                layout_.folder().string() +
                    ": holds no cell; name the cells by --methods, --ratios and --seeds");
  }
  return run::resolve(options);
}

}  // namespace piae::run

#include "run/layout.hpp"

#include <algorithm>
#include <system_error>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "scoring/ratios.hpp"

namespace piae::run {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> folders_in(const fs::path& folder) {
  std::vector<fs::path> folders;
  std::error_code no_folder;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, no_folder)) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  std::ranges::sort(folders);
  return folders;
}

/// True if the folder holds sweeps or interpretations, which lie next to the methods' folders.
bool holds_trials(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name == "sweep" || name.starts_with("sweep@") || name == "readings";
}

/// Returns a diagnosis in the layout from before 0.1.0, where the paper's classifier had its cells
/// in the folder of the ratio. `folder` belongs to a seed, or to its sweeps or interpretations.
std::optional<fs::path> cell_of_before(const fs::path& folder) {
  for (const fs::path& method : folders_in(folder)) {
    for (const scoring::Ratio& ratio : scoring::all_ratios()) {
      const fs::path cell = method / ratio.name / "diagnosis.h5";
      if (fs::is_regular_file(cell)) return cell;
    }
    if (!holds_trials(method)) continue;
    if (const auto cell = cell_of_before(method)) return cell;
  }
  return std::nullopt;
}

}  // namespace

std::string sweep_name(const std::string& method) {
  return method == augment::paper_method() ? "sweep" : "sweep@" + method;
}

Layout::Layout(const fs::path& run, const std::string& dataset) : folder_(run / dataset) {
  for (const std::int64_t seed : seeds()) {
    const auto cell = cell_of_before(seed_folder(seed));
    if (!cell) continue;
    throw Error(Exit::bad_input, folder_.string() + ": its cells are laid out as before 0.1.0 (" +
                                     cell->lexically_relative(folder_).string() +
                                     "); pipeline/new_layout.sh " + run.string() + " moves them");
  }
}

std::vector<std::int64_t> Layout::seeds() const {
  const std::string prefix = "seed";
  std::vector<std::int64_t> seeds;
  std::error_code no_folder;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, no_folder)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory() || !name.starts_with(prefix)) continue;
    const auto seed = number_in<std::int64_t>(name.substr(prefix.size()));
    if (seed && *seed >= 0) seeds.push_back(*seed);
  }
  std::ranges::sort(seeds);
  seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());  // such as seed01
  return seeds;
}

std::optional<fs::path> Layout::unfinished_log(const fs::path& cell) {
  struct Step {
    fs::path folder;
    const char* log;
    const char* result;
  };
  const bool is_score = cell.filename() == "score.h5";
  const fs::path folder = cell.parent_path();
  const fs::path method = is_score ? folder : folder.parent_path().parent_path();
  const Step steps[] = {
      {method.parent_path(), "split.log", "D.h5"},
      {method, "train.log", "model.h5"},
      {method, "generate.log", "E.h5"},
      {folder, is_score ? "score.log" : "diagnose.log", is_score ? "score.h5" : "diagnosis.h5"}};
  for (const Step& step : steps) {
    if (fs::exists(step.folder / step.log) && !fs::exists(step.folder / step.result)) {
      return step.folder / step.log;
    }
  }
  return std::nullopt;
}

}  // namespace piae::run

#include "run/layout.hpp"

#include <algorithm>
#include <system_error>

#include "augment/catalogue.hpp"
#include "base/numbers.hpp"

namespace piae::run {

namespace fs = std::filesystem;

std::string sweep_name(const std::string& method) {
  return method == augment::paper_method() ? "sweep" : "sweep@" + method;
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

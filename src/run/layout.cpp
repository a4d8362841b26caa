#include "run/layout.hpp"

namespace piae::run {

namespace fs = std::filesystem;

std::optional<fs::path> Layout::unfinished_log(const fs::path& cell) {
  struct Step {
    fs::path folder;
    const char* log;
    const char* result;
  };
  const bool is_score = cell.filename() == "score.h5";
  const fs::path folder = cell.parent_path();
  const fs::path method = is_score ? folder : folder.parent_path();
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

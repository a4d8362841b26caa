#include "page/hole.hpp"

#include <algorithm>
#include <optional>

#include "page/step_log.hpp"

namespace piae::page {

namespace fs = std::filesystem;

namespace {

fs::path file_of(const run::Layout& layout, const run::CellName& name) {
  return name.ratio.empty() ? layout.score(name.method, name.seed)
                            : layout.diagnosis(name.method, name.ratio, name.seed, name.classifier);
}

/// What collecting said of a file; all its errors name the file.
std::string problem_with(const fs::path& file, const std::vector<std::string>& problems) {
  const auto found = std::ranges::find_if(problems, [&](const std::string& problem) {
    return problem.find(file.string()) != std::string::npos;
  });
  return found == problems.end() ? "" : found->substr(found->find(file.string()));
}

/// The log of the first step on the way to a cell that is not done; also that of a data set's
/// recordings, without which nothing else has begun.
std::optional<fs::path> log_on_the_way(const run::Layout& layout, const fs::path& file) {
  if (auto log = run::Layout::unfinished_log(file)) return log;
  if (fs::exists(layout.folder() / "records.h5")) return std::nullopt;
  for (const char* name : {"ingest.log", "simulate.log"}) {
    if (fs::exists(layout.folder() / name)) return layout.folder() / name;
  }
  return std::nullopt;
}

HoleState state_of(const StepLog& log) {
  switch (log.end) {
    case StepEnd::failed:
      return HoleState::failed;
    case StepEnd::interrupted:
      return HoleState::interrupted;
    case StepEnd::open:
      return HoleState::open;
    case StepEnd::done:  // and then its file was removed
      break;
  }
  return HoleState::not_begun;
}

}  // namespace

std::string below_run(std::string text, const fs::path& run) {
  const std::string folder = (run / "").string();
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at)) {
    text.erase(at, folder.size());
  }
  return text;
}

Hole hole_of(const fs::path& run, const run::Layout& layout, const run::CellName& name,
             const std::vector<std::string>& problems) {
  const fs::path file = file_of(layout, name);
  Hole hole{.name = name};
  if (fs::exists(file)) {
    hole.state = HoleState::refused;
    hole.why = below_run(problem_with(file, problems), run);
    return hole;
  }
  const std::optional<fs::path> path = log_on_the_way(layout, file);
  if (!path) return hole;
  const StepLog log = read_step_log(*path);
  hole.state = state_of(log);
  hole.stage = log.stage;
  hole.why = below_run(log.reason, run);
  hole.log = path->lexically_relative(run);
  return hole;
}

}  // namespace piae::page

#include "page/hole.hpp"

#include <cctype>
#include <optional>
#include <string_view>

#include "run/step_log.hpp"

namespace piae::page {

namespace fs = std::filesystem;

namespace {

fs::path file_of(const run::Layout& layout, const run::CellName& name) {
  return name.ratio.empty() ? layout.score(name.method, name.seed)
                            : layout.diagnosis(name.method, name.ratio, name.seed, name.classifier);
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

HoleState state_of(const run::StepLog& log) {
  switch (log.end) {
    case run::StepEnd::failed:
      return HoleState::failed;
    case run::StepEnd::interrupted:
      return HoleState::interrupted;
    case run::StepEnd::open:
      return HoleState::open;
    case run::StepEnd::done:  // and then its file was removed
      break;
  }
  return HoleState::not_begun;
}

/// Whether a path may go on from this character: what stands behind it is not its beginning.
bool may_be_in_path(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) != 0 || byte > 127 ||
         std::string_view("/._-@+").find(c) != std::string_view::npos;
}

}  // namespace

std::string below_run(std::string text, const fs::path& run) {
  const std::string folder = (run / "").string();
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at)) {
    if (at > 0 && may_be_in_path(text[at - 1])) {
      ++at;
    } else {
      text.erase(at, folder.size());
    }
  }
  return text;
}

ProblemsByFile::ProblemsByFile(const run::Layout& layout,
                               const std::vector<std::string>& problems) {
  const std::string folder = (layout.folder() / "").string();
  const std::string ending = ".h5";
  for (const std::string& problem : problems) {
    const std::size_t begin = problem.find(folder);
    if (begin == std::string::npos) continue;
    const std::size_t end = problem.find(ending, begin + folder.size());
    if (end == std::string::npos) continue;
    problems_.emplace(problem.substr(begin, end + ending.size() - begin), problem.substr(begin));
  }
}

std::string ProblemsByFile::with(const fs::path& file) const {
  const auto found = problems_.find(file.string());
  return found == problems_.end() ? "" : found->second;
}

Hole hole_of(const fs::path& run, const run::Layout& layout, const run::CellName& name,
             const ProblemsByFile& problems) {
  const fs::path file = file_of(layout, name);
  Hole hole{.name = name};
  if (fs::exists(file)) {
    hole.state = HoleState::refused;
    hole.why = below_run(problems.with(file), run);
    return hole;
  }
  const std::optional<fs::path> path = log_on_the_way(layout, file);
  if (!path) return hole;
  const run::StepLog log = run::read_step_log(*path);
  hole.state = state_of(log);
  hole.stage = log.stage;
  hole.why = below_run(log.reason, run);
  hole.log = path->lexically_relative(run);
  return hole;
}

}  // namespace piae::page

#include "page/contents.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>

#include "augment/catalogue.hpp"
#include "report/accuracies.hpp"
#include "report/verdict.hpp"
#include "run/held.hpp"
#include "run/step_log.hpp"

namespace piae::page {

namespace fs = std::filesystem;

namespace {

fs::path file_of(const run::Layout& layout, const run::CellName& name) {
  return name.ratio.empty() ? layout.score(name.method, name.seed)
                            : layout.diagnosis(name.method, name.ratio, name.seed, name.classifier);
}

/// Returns the log of the first unfinished step on the way to a cell. Includes the data set's
/// recordings, without which nothing else can start.
std::optional<fs::path> log_on_the_way(const run::Layout& layout, const fs::path& file) {
  if (auto log = run::Layout::unfinished_log(file)) return log;
  if (fs::exists(layout.folder() / "records.h5")) return std::nullopt;
  for (const char* name : {"ingest.log", "simulate.log"}) {
    if (fs::exists(layout.folder() / name)) return layout.folder() / name;
  }
  return std::nullopt;
}

MissingState state_of(const run::StepLog& log) {
  switch (log.end) {
    case run::StepEnd::failed:
      return MissingState::failed;
    case run::StepEnd::interrupted:
      return MissingState::interrupted;
    case run::StepEnd::open:
      return MissingState::open;
    case run::StepEnd::done:  // and its file was removed later
      break;
  }
  return MissingState::not_started;
}

/// True if `c` can be part of a path. Text after such a character does not start a path.
bool may_be_in_path(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) != 0 || byte > 127 ||
         std::string_view("/._-@+").find(c) != std::string_view::npos;
}

Build build_of(const artefact::Reader& reader) {
  const std::string group = "/provenance";
  return {.version = reader.text(group, "version"),
          .libraries = reader.text(group, "libraries"),
          .processor = reader.text(group, "cpu")};
}

/// Names of cells; there may be a hundred thousand.
using CellNames = std::set<std::tuple<std::string, std::string, std::int64_t, std::string>>;

CellNames::value_type key_of(const run::CellName& name) {
  return {name.method, name.ratio, name.seed, name.classifier};
}

/// Returns the cells that were read or left out.
CellNames none_missing(const run::Results& results) {
  CellNames names;
  for (const run::Diagnosis& cell : results.diagnoses) {
    names.insert({cell.method, cell.ratio, cell.seed, cell.classifier});
  }
  for (const scoring::QualityRecord& cell : results.qualities) {
    names.insert(key_of({cell.method, "", cell.seed}));
  }
  for (const run::CellName& cell : results.left_out) names.insert(key_of(cell));
  return names;
}

std::vector<run::CellName> cells_of(const run::Grid& grid) {
  std::vector<run::CellName> names;
  for (const run::Combination& cell : grid.combinations) {
    for (const std::int64_t seed : grid.seeds) {
      names.push_back({cell.method, cell.ratio, seed, cell.classifier});
    }
  }
  for (const std::string& method : grid.scored) {
    for (const std::int64_t seed : grid.seeds) names.push_back({method, "", seed});
  }
  return names;
}

bool is_among(const run::Grid& grid, const run::CellName& name) {
  if (std::ranges::count(grid.seeds, name.seed) == 0) return false;
  if (name.ratio.empty()) return std::ranges::count(grid.scored, name.method) > 0;
  return std::ranges::count(grid.combinations,
                            run::Combination{name.method, name.ratio, name.classifier}) > 0;
}

/// Returns the cells that were requested or started, and could not be read.
std::vector<MissingCell> missing_cells_in(const fs::path& run, const run::Grid& requested,
                                          const DatasetContents& contents) {
  const run::Layout layout(run, contents.name);
  std::vector<run::CellName> names = cells_of(requested);
  for (run::CellName& name : cells_of(contents.grid)) {
    if (!is_among(requested, name)) names.push_back(std::move(name));
  }
  const CellNames whole = none_missing(contents.results);
  const ProblemsByFile problems(layout, contents.results.problems);
  std::vector<MissingCell> missing_cells;
  for (const run::CellName& name : names) {
    if (whole.contains(key_of(name))) continue;
    MissingCell missing_cell = as_missing_cell(run, layout, name, problems);
    const bool counts =
        is_among(requested, name) || missing_cell.state != MissingState::not_started;
    if (counts) missing_cells.push_back(std::move(missing_cell));
  }
  return missing_cells;
}

/// Reads "ROLE FILE DIGEST", the format of an artefact's inputs in its provenance.
RecordInput record_input(const std::string& line) {
  const std::size_t role = line.find(' ');
  const std::size_t digest = line.rfind(' ');
  return {.file = line.substr(role + 1, digest - role - 1), .digest = line.substr(digest + 1)};
}

void read_records(const fs::path& run, DatasetContents& contents) {
  const fs::path file = run::Layout(run, contents.name).folder() / "records.h5";
  if (!fs::exists(file)) return;
  try {
    const artefact::Reader reader(file, "records");
    contents.records_digest = reader.digest();
    for (const std::string& line : reader.strings("/provenance/inputs")) {
      contents.records.push_back(record_input(line));
    }
  } catch (const Error& error) {
    contents.records_problem = below_run(error.what(), run);
  }
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

MissingCell as_missing_cell(const fs::path& run, const run::Layout& layout,
                            const run::CellName& name, const ProblemsByFile& problems) {
  const fs::path file = file_of(layout, name);
  MissingCell missing_cell{.name = name};
  if (fs::exists(file)) {
    missing_cell.state = MissingState::refused;
    missing_cell.why = below_run(problems.with(file), run);
    return missing_cell;
  }
  const std::optional<fs::path> path = log_on_the_way(layout, file);
  if (!path) return missing_cell;
  const run::StepLog log = run::read_step_log(*path);
  missing_cell.state = state_of(log);
  missing_cell.stage = log.stage;
  missing_cell.why = below_run(log.reason, run);
  missing_cell.log = path->lexically_relative(run);
  return missing_cell;
}

DatasetContents read_dataset(const fs::path& run, const run::Grid& requested,
                             const std::vector<std::string>& leave_out,
                             const report::Published& published) {
  const run::Layout layout(run, requested.dataset);
  DatasetContents contents{.name = requested.dataset};
  const auto note = [&](const artefact::Reader& cell) {
    ++contents.builds[build_of(cell)];
    const bool is_score = cell.kind() == "score";
    (is_score ? contents.score_digests : contents.diagnosis_digests).push_back(cell.digest());
  };
  run::Collected collected =
      run::collect_held(layout, requested, run::Held(layout, leave_out), note);
  contents.grid = std::move(collected.grid);
  contents.results = std::move(collected.results);
  contents.rows = report::accuracy_rows(contents.grid, contents.results, published);
  contents.tables = report::report_tables(contents.rows, contents.results,
                                          report::recommendations(contents.rows, contents.results),
                                          contents.grid.seeds.size());
  contents.verdict = report::verdict(contents.results, contents.rows);
  const std::string conditions = report::conditions_note(contents.results);
  if (!conditions.empty()) contents.verdict.insert(contents.verdict.begin(), conditions);
  contents.missing_cells = missing_cells_in(run, requested, contents);
  read_records(run, contents);
  return contents;
}

std::string counted_cells(std::size_t diagnoses, std::size_t scores) {
  std::string first = fmt::format("{} diagnos{}", diagnoses, diagnoses == 1 ? "is" : "es");
  std::string second = report::counted(scores, "score");
  if (scores == 0) return first;
  return diagnoses == 0 ? second : first + " and " + second;
}

}  // namespace piae::page

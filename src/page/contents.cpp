#include "page/contents.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "augment/catalogue.hpp"
#include "report/accuracies.hpp"
#include "report/verdict.hpp"
#include "run/held.hpp"

namespace piae::page {

namespace fs = std::filesystem;

namespace {

Build build_of(const artefact::Reader& reader) {
  const std::string group = "/provenance";
  return {.version = reader.text(group, "version"),
          .libraries = reader.text(group, "libraries"),
          .processor = reader.text(group, "cpu")};
}

run::CellName name_of(const run::Diagnosis& cell) {
  return {cell.method, cell.ratio, cell.seed, cell.classifier};
}

/// Names of cells, of which there may be a hundred thousand.
class CellNames {
 public:
  void add(const run::CellName& name) { keys_.insert(key_of(name)); }
  [[nodiscard]] bool has(const run::CellName& name) const { return keys_.contains(key_of(name)); }

 private:
  using Key = std::tuple<std::string, std::string, std::int64_t, std::string>;
  static Key key_of(const run::CellName& name) {
    return {name.method, name.ratio, name.seed, name.classifier};
  }
  std::set<Key> keys_;
};

/// Those that are read, or left out.
CellNames no_holes(const run::Results& results) {
  CellNames names;
  for (const run::Diagnosis& cell : results.diagnoses) names.add(name_of(cell));
  for (const scoring::QualityRecord& cell : results.qualities) {
    names.add({cell.method, "", cell.seed});
  }
  for (const run::CellName& cell : results.left_out) names.add(cell);
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

/// The cells that are asked for, or were begun, and could not be read.
std::vector<Hole> holes_in(const fs::path& run, const run::Grid& asked,
                           const DatasetContents& contents) {
  const run::Layout layout(run, contents.name);
  std::vector<run::CellName> names = cells_of(asked);
  for (run::CellName& name : cells_of(contents.grid)) {
    if (!is_among(asked, name)) names.push_back(std::move(name));
  }
  const CellNames whole = no_holes(contents.results);
  const ProblemsByFile problems(layout, contents.results.problems);
  std::vector<Hole> holes;
  for (const run::CellName& name : names) {
    if (whole.has(name)) continue;
    Hole hole = hole_of(run, layout, name, problems);
    const bool counts = is_among(asked, name) || hole.state != HoleState::not_begun;
    if (counts) holes.push_back(std::move(hole));
  }
  return holes;
}

/// "ROLE FILE DIGEST", as provenance holds the inputs of an artefact.
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

DatasetContents read_dataset(const fs::path& run, const run::Grid& asked,
                             const std::vector<std::string>& leave_out,
                             const report::Published& published) {
  const run::Layout layout(run, asked.dataset);
  DatasetContents contents{.name = asked.dataset};
  const auto note = [&](const artefact::Reader& cell) {
    ++contents.builds[build_of(cell)];
    const bool is_score = cell.kind() == "score";
    (is_score ? contents.score_digests : contents.diagnosis_digests).push_back(cell.digest());
  };
  run::Collected collected = run::collect_held(layout, asked, run::Held(layout, leave_out), note);
  contents.grid = std::move(collected.grid);
  contents.results = std::move(collected.results);
  contents.rows = report::accuracy_rows(contents.grid, contents.results, published);
  contents.recommendations = report::recommendations(contents.rows, contents.results);
  contents.verdict = report::verdict(contents.results, contents.rows);
  const std::string conditions = report::conditions_note(contents.results);
  if (!conditions.empty()) contents.verdict.insert(contents.verdict.begin(), conditions);
  contents.holes = holes_in(run, asked, contents);
  read_records(run, contents);
  return contents;
}

std::string counted_cells(std::size_t diagnoses, std::size_t scores) {
  std::string first = fmt::format("{} diagnos{}", diagnoses, diagnoses == 1 ? "is" : "es");
  std::string second = fmt::format("{} score{}", scores, scores == 1 ? "" : "s");
  if (scores == 0) return first;
  return diagnoses == 0 ? second : first + " and " + second;
}

}  // namespace piae::page

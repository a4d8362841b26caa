#include "run/collect.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <functional>

#include "scoring/diagnosis_record.hpp"

namespace piae::run {

namespace {

namespace fs = std::filesystem;

void require_same(const artefact::Reader& reader, const std::string& what, const std::string& holds,
                  const std::string& needed) {
  if (holds != needed) reader.refuse("/", what + " is " + holds + ", here it must be " + needed);
}

/// Cells of one table must agree with those before them.
void require_like_the_others(const artefact::Reader& reader, const Diagnosis& cell,
                             const std::vector<Diagnosis>& others) {
  if (others.empty()) return;
  require_same(reader, "the split protocol", cell.protocol, others.front().protocol);
  const auto peer = std::ranges::find(others, cell.ratio, &Diagnosis::ratio);
  if (peer == others.end()) return;
  require_same(reader, "the number of generated windows per class",
               std::to_string(cell.generated_per_class), std::to_string(peer->generated_per_class));
  require_same(reader, "the true ratio", std::to_string(cell.true_ratio),
               std::to_string(peer->true_ratio));
}

std::string class_names(const scoring::QualityRecord& record) {
  std::string names;
  for (const scoring::ClassQuality& quality : record.classes) {
    names += (names.empty() ? "" : " ") +
             record.info.classes[static_cast<std::size_t>(quality.label)].name;
  }
  return names;
}

void add_diagnosis(const fs::path& path, const std::string& dataset, const Combination& place,
                   std::int64_t seed, std::vector<Diagnosis>& diagnoses) {
  const artefact::Reader reader(path, "diagnosis");
  const scoring::DiagnosisRecord record = scoring::read_diagnosis(reader);
  require_same(reader, "the dataset", record.info.name, dataset);
  require_same(reader, "the method", record.method, place.method);
  require_same(reader, "the ratio", record.ratio, place.ratio);
  require_same(reader, "the seed", std::to_string(record.seed), std::to_string(seed));
  const Diagnosis cell{
      record.method,     record.ratio,    record.seed,      record.generated_per_class,
      record.true_ratio, record.protocol, record.accuracy()};
  require_like_the_others(reader, cell, diagnoses);
  diagnoses.push_back(cell);
}

void add_quality(const fs::path& path, const std::string& dataset, const std::string& method,
                 std::int64_t seed, std::vector<scoring::QualityRecord>& qualities) {
  const artefact::Reader reader(path, "score");
  scoring::QualityRecord record = scoring::read_quality(reader);
  require_same(reader, "the dataset", record.info.name, dataset);
  require_same(reader, "the method", record.method, method);
  require_same(reader, "the seed", std::to_string(record.seed), std::to_string(seed));
  if (!qualities.empty()) {
    require_same(reader, "the split protocol", record.protocol, qualities.front().protocol);
    require_same(reader, "the list of classes", class_names(record),
                 class_names(qualities.front()));
  }
  qualities.push_back(std::move(record));
}

/// Where a file of the grid should be, and what it should hold.
struct Place {
  std::string cell;  ///< in words
  fs::path path;
  std::function<void()> read;
};

void attempt(const Place& place, Results& results) {
  try {
    place.read();
  } catch (const Error& error) {
    std::string problem = place.cell + ": " + error.what();
    const auto log = Layout::unfinished_log(place.path);
    if (error.exit() == Exit::input_missing && log) {
      problem += "; a step on the way to it failed or is not done, see " + log->string();
    }
    results.problems.push_back(problem);
    if (results.exit != Exit::bad_input) results.exit = error.exit();
  }
}

}  // namespace

void collect_diagnoses(const Layout& layout, const Grid& grid, const Series& series,
                       Results& results) {
  const Combination& cell = series.combination;
  for (const std::int64_t seed : grid.seeds) {
    const fs::path path = layout.diagnosis(series.folder, cell.ratio, seed);
    attempt({fmt::format("{}, ratio {}, seed {}", series.name, cell.ratio, seed), path,
             [&] { add_diagnosis(path, grid.dataset, cell, seed, results.diagnoses); }},
            results);
  }
}

Results collect(const Layout& layout, const Grid& grid) {
  Results results;
  for (const Combination& cell : grid.combinations) {
    collect_diagnoses(layout, grid, {"method " + cell.method, cell.method, cell}, results);
  }
  for (const std::string& method : grid.scored) {
    for (const std::int64_t seed : grid.seeds) {
      const fs::path path = layout.score(method, seed);
      attempt({fmt::format("method {}, seed {}", method, seed), path,
               [&] { add_quality(path, grid.dataset, method, seed, results.qualities); }},
              results);
    }
  }
  return results;
}

void refuse_outdated(const std::vector<fs::path>& files, Results& results) {
  for (const fs::path& file : files) {
    results.problems.push_back(file.string() + ": is out of date and could not be made again");
    results.exit = Exit::bad_input;
  }
}

void require_all(const Results& results) {
  if (results.problems.empty()) return;
  for (const std::string& problem : results.problems) spdlog::error(problem);
  throw Error(
      results.exit,
      fmt::format("{} of the files that the tables need {} missing or refused; no table was "
                  "written (make the cells named above, or ask for fewer)",
                  results.problems.size(), results.problems.size() == 1 ? "is" : "are"));
}

}  // namespace piae::run

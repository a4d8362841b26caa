#include "run/collect.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace piae::run {

namespace {

namespace fs = std::filesystem;

std::string known_label(const Diagnosis& cell) { return cell.any_known ? "above zero" : "zero"; }

std::string ratio_label(const Diagnosis& cell) {
  return cell.true_ratio ? std::to_string(*cell.true_ratio) : "none, without fault windows";
}

std::string class_names(const Diagnosis& cell) {
  std::string names;
  for (const signal::ClassInfo& each : cell.classes)
    names += (names.empty() ? "" : " ") + each.name;
  return names;
}

std::string class_names(const scoring::QualityRecord& record) {
  std::string names;
  for (const scoring::ClassQuality& quality : record.classes) {
    names += (names.empty() ? "" : " ") + record.info.class_of(quality.label).name;
  }
  return names;
}

/// Refuses a cell that was made under other conditions than the cells before it.
void require_like_the_others(const artefact::Reader& reader, const Diagnosis& cell,
                             const std::vector<Diagnosis>& others) {
  if (others.empty()) return;
  require_same(reader, "the split protocol", to_string(cell.protocol),
               to_string(others.front().protocol));
  require_same(reader, "the number of known windows", known_label(cell),
               known_label(others.front()));
  require_same(reader, "the list of classes", class_names(cell), class_names(others.front()));
  // Search backwards, where the match is near: cells are sorted by ratio, with perhaps thousands of
  // seeds.
  const auto same_ratio = std::find_if(others.rbegin(), others.rend(), [&](const Diagnosis& each) {
    return each.ratio == cell.ratio;
  });
  if (same_ratio == others.rend()) return;
  require_same(reader, "the number of generated windows per class",
               std::to_string(cell.generated_per_class),
               std::to_string(same_ratio->generated_per_class));
  require_same(reader, "the true ratio", ratio_label(cell), ratio_label(*same_ratio));
}

void add_diagnosis(const artefact::Reader& reader, const std::string& dataset,
                   const Combination& combination, std::int64_t seed,
                   const TestedWindowsBySeed& tested, const SeenCell& seen,
                   std::vector<Diagnosis>& diagnoses) {
  const auto windows = tested.find(seed);
  Diagnosis cell = read_diagnosis_cell(reader, dataset, combination, seed,
                                       windows == tested.end() ? nullptr : &windows->second);
  require_like_the_others(reader, cell, diagnoses);
  if (seen) seen(reader);
  diagnoses.push_back(std::move(cell));
}

void add_quality(const artefact::Reader& reader, const std::string& dataset,
                 const std::string& method, std::int64_t seed, const SeenCell& seen,
                 std::vector<scoring::QualityRecord>& qualities) {
  scoring::QualityRecord record = read_score_cell(reader, dataset, method, seed);
  if (!qualities.empty()) {
    require_same(reader, "the split protocol", to_string(record.protocol),
                 to_string(qualities.front().protocol));
    require_same(reader, "the list of classes", class_names(record),
                 class_names(qualities.front()));
  }
  if (seen) seen(reader);
  qualities.push_back(std::move(record));
}

/// A file to be read, its cell in words, and the function that takes it.
struct Wanted {
  std::string name;
  fs::path path;
  std::function<void(const artefact::Reader&)> read;
};

std::string problem_of(const Wanted& file, const Error& error) {
  const std::string problem = file.name + ": " + error.what();
  const auto log = Layout::unfinished_log(file.path);
  if (error.exit() != Exit::input_missing || !log) return problem;
  return problem + "; a step before it failed or is missing, see " + log->string();
}

/// Reads files of one kind in turn. Adds their problems to the results.
void read_all(const std::vector<Wanted>& files, const std::string& kind, Results& results) {
  std::vector<fs::path> paths;
  paths.reserve(files.size());
  for (const Wanted& file : files) paths.push_back(file.path);
  artefact::Readers readers(std::move(paths), kind);
  for (const Wanted& file : files) {
    try {
      file.read(readers.next());
    } catch (const Error& error) {
      results.problems.push_back(problem_of(file, error));
      if (results.exit != Exit::bad_input) results.exit = error.exit();
    }
  }
}

}  // namespace

Series series_of(const Combination& combination) {
  return {.name = "method " + name_by(combination.method, combination.classifier),
          .folder = combination.method,
          .combination = combination};
}

void collect_tested_windows(const Layout& layout, const std::string& dataset,
                            const std::vector<std::int64_t>& seeds, TestedWindowsBySeed& windows,
                            Results& results) {
  std::vector<Wanted> files;
  files.reserve(seeds.size());
  for (const std::int64_t seed : seeds) {
    files.push_back({fmt::format("test windows, seed {}", seed), layout.windows("A", seed),
                     [&, seed](const artefact::Reader& reader) {
                       windows.emplace(seed, read_tested_windows(reader, dataset, seed));
                     }});
  }
  read_all(files, "windows", results);
}

std::vector<Diagnosis> diagnoses_of(const Results& results, const Combination& combination) {
  std::vector<Diagnosis> own;
  std::ranges::copy_if(results.diagnoses, std::back_inserter(own), [&](const Diagnosis& cell) {
    return Combination{cell.method, cell.ratio, cell.classifier} == combination;
  });
  return own;
}

void collect_diagnoses(const Layout& layout, const std::string& dataset,
                       const std::vector<SeriesOfSeeds>& all, Results& results,
                       const TestedWindowsBySeed& tested, const SeenCell& seen) {
  std::vector<Wanted> files;
  for (const SeriesOfSeeds& each : all) {
    const Series& series = each.series;
    const Combination& cell = series.combination;
    for (const std::int64_t seed : each.seeds) {
      files.push_back({fmt::format("{}, ratio {}, seed {}", series.name, cell.ratio, seed),
                       layout.diagnosis(series.folder, cell.ratio, seed, cell.classifier),
                       [&, seed](const artefact::Reader& reader) {
                         add_diagnosis(reader, dataset, cell, seed, tested, seen,
                                       results.diagnoses);
                       }});
    }
  }
  read_all(files, "diagnosis", results);
}

void collect_scores(const Layout& layout, const std::string& dataset,
                    const std::vector<MethodOfSeeds>& all, Results& results, const SeenCell& seen) {
  std::vector<Wanted> files;
  for (const MethodOfSeeds& each : all) {
    const std::string& method = each.method;
    for (const std::int64_t seed : each.seeds) {
      files.push_back({fmt::format("method {}, seed {}", method, seed), layout.score(method, seed),
                       [&, seed](const artefact::Reader& reader) {
                         add_quality(reader, dataset, method, seed, seen, results.qualities);
                       }});
    }
  }
  read_all(files, "score", results);
}

std::vector<SeriesOfSeeds> series_of(const Grid& grid) {
  std::vector<SeriesOfSeeds> all;
  all.reserve(grid.combinations.size());
  for (const Combination& cell : grid.combinations) all.push_back({series_of(cell), grid.seeds});
  return all;
}

Results collect(const Layout& layout, const Grid& grid) {
  Results results;
  collect_diagnoses(layout, grid.dataset, series_of(grid), results);
  std::vector<MethodOfSeeds> scored;
  scored.reserve(grid.scored.size());
  for (const std::string& method : grid.scored) scored.push_back({method, grid.seeds});
  collect_scores(layout, grid.dataset, scored, results);
  return results;
}

void require_all(const Results& results) {
  if (results.problems.empty()) return;
  for (const std::string& problem : results.problems) spdlog::error(problem);
  throw Error(
      results.exit,
      fmt::format("{} of the files that the tables need {} missing or refused; no table was "
                  "written (make the cells named above, or request fewer)",
                  results.problems.size(), results.problems.size() == 1 ? "is" : "are"));
}

}  // namespace piae::run

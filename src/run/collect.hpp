#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "run/cell.hpp"
#include "run/grid.hpp"
#include "run/layout.hpp"
#include "scoring/quality_record.hpp"

namespace piae::run {

/// Names a cell. The ratio of a score is empty.
struct CellName {
  std::string method;
  std::string ratio;
  std::int64_t seed = 0;
  std::string classifier = scoring::paper_classifier;

  bool operator==(const CellName&) const = default;
};

/// Cells of a grid that were read, and the problems of the others.
struct Results {
  std::vector<Diagnosis> diagnoses;               ///< by combination, then seed
  std::vector<scoring::QualityRecord> qualities;  ///< by method, then seed
  std::vector<CellName> left_out;                 ///< stale cells that exist (run/held.hpp)
  std::vector<std::string> problems;  ///< one line for each missing or refused file, with its cell
  /// Exit code of a program that needs all cells: bad_input if any file is refused, else
  /// input_missing if any is missing.
  Exit exit = Exit::done;
};

/// Callback, called for each accepted cell with its artefact, in the order of the results, to read
/// what tables do not need. Refuses the cell by throwing artefact::Refusal.
using SeenCell = std::function<void(const artefact::Reader&)>;

/// Diagnoses of one method and ratio over the seeds: cells of the grid, or of a sweep with one
/// setting of the method moved.
struct Series {
  std::string name;    ///< in words: "method piae-dt", "batch 1"
  std::string folder;  ///< below the folder of each seed: "piae-dt", "sweep/batch-1"
  Combination combination;
};

/// Returns the series of the grid itself.
Series series_of(const Combination& combination);

/// Adds the test windows (A) of these seeds, or their problems, to the results.
void collect_tested_windows(const Layout& layout, const std::string& dataset,
                            const std::vector<std::int64_t>& seeds, TestedWindowsBySeed& windows,
                            Results& results);

/// A series, and the seeds that it has.
struct SeriesOfSeeds {
  Series series;
  std::vector<std::int64_t> seeds;
};

/// Adds the diagnoses of these series, or their problems, to the results. They have decisions if
/// the test windows of their seed are known. One call for many series is faster than one for each
/// (artefact::Readers).
void collect_diagnoses(const Layout& layout, const std::string& dataset,
                       const std::vector<SeriesOfSeeds>& all, Results& results,
                       const TestedWindowsBySeed& tested = {}, const SeenCell& seen = {});

/// Returns the series of a grid, each at all of its seeds.
std::vector<SeriesOfSeeds> series_of(const Grid& grid);

/// Returns the diagnoses of one combination, by seed.
std::vector<Diagnosis> diagnoses_of(const Results& results, const Combination& combination);

/// A method, and the seeds of its scores.
struct MethodOfSeeds {
  std::string method;
  std::vector<std::int64_t> seeds;
};

/// Adds scores, as collect_diagnoses() adds diagnoses.
void collect_scores(const Layout& layout, const std::string& dataset,
                    const std::vector<MethodOfSeeds>& all, Results& results,
                    const SeenCell& seen = {});

/// Reads every cell of a grid, and continues after a cell that cannot be read. Also refuses a file
/// that holds another cell than its place requires, and a file made under other conditions than
/// those before it (split protocol, numbers of windows at the same ratio, classes): a table must
/// not average such cells.
Results collect(const Layout& layout, const Grid& grid);

/// Logs a line for each problem and throws an Error with their number, so that a table never has a
/// missing cell.
void require_all(const Results& results);

}  // namespace piae::run

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

/// A cell by its name. The ratio is empty for a score.
struct CellName {
  std::string method;
  std::string ratio;
  std::int64_t seed = 0;
  std::string classifier = scoring::paper_classifier;

  bool operator==(const CellName&) const = default;
};

/// The cells of a grid that could be read, and what is wrong with the others.
struct Results {
  std::vector<Diagnosis> diagnoses;               ///< by combination, then seed
  std::vector<scoring::QualityRecord> qualities;  ///< by method, then seed
  std::vector<CellName> left_out;     ///< cells that are there but out of date (run/held.hpp)
  std::vector<std::string> problems;  ///< one line for each missing or refused file, with its cell
  /// What a program that needs all cells exits with: bad_input if any file is refused, else
  /// input_missing if any is missing.
  Exit exit = Exit::done;
};

/// Is shown each cell that becomes part of the results, with the artefact that it was read from, in
/// the order of the results: for what tables do not need of artefacts. A cell is refused with the
/// artefact::Refusal that this throws.
using SeenCell = std::function<void(const artefact::Reader&)>;

/// The diagnoses of one method and ratio over the seeds: those of the grid, or those of a sweep
/// with one setting of the method moved.
struct Series {
  std::string name;    ///< in words: "method piae-dt", "batch 1"
  std::string folder;  ///< below the folder of each seed: "piae-dt", "sweep/batch-1"
  Combination combination;
};

/// The series of the grid itself.
Series series_of(const Combination& combination);

/// Adds the test windows (A) of these seeds, or what is wrong with them to the results.
void collect_tested_windows(const Layout& layout, const std::string& dataset,
                            const std::vector<std::int64_t>& seeds, TestedWindowsBySeed& windows,
                            Results& results);

/// A series, and the seeds at which it is read.
struct SeriesOfSeeds {
  Series series;
  std::vector<std::int64_t> seeds;
};

/// Adds the diagnoses of these series to the results, or what is wrong with them. Those of seeds
/// whose test windows are known have decisions. Many series in one call take less than one at a
/// time (artefact::Readers).
void collect_diagnoses(const Layout& layout, const std::string& dataset,
                       const std::vector<SeriesOfSeeds>& all, Results& results,
                       const TestedWindowsBySeed& tested = {}, const SeenCell& seen = {});

/// The series of a grid, each at all of its seeds.
std::vector<SeriesOfSeeds> series_of(const Grid& grid);

/// The diagnoses of one combination, by seed.
std::vector<Diagnosis> diagnoses_of(const Results& results, const Combination& combination);

/// A method, and the seeds at which its scores are read.
struct MethodOfSeeds {
  std::string method;
  std::vector<std::int64_t> seeds;
};

/// The same for scores.
void collect_scores(const Layout& layout, const std::string& dataset,
                    const std::vector<MethodOfSeeds>& all, Results& results,
                    const SeenCell& seen = {});

/// Reads every cell of a grid, and goes on after one that cannot be read. A file is also refused
/// when it holds another cell than its place says, and when it was made under other conditions than
/// the files before it (split protocol, numbers of windows at the same ratio, classes), since a
/// table must not average what does not belong together.
Results collect(const Layout& layout, const Grid& grid);

/// Where there is any problem, logs a line for each and throws an Error that counts them: no table
/// is written with a hole in it.
void require_all(const Results& results);

}  // namespace piae::run

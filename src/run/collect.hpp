#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "run/grid.hpp"
#include "run/layout.hpp"
#include "scoring/quality_record.hpp"

namespace piae::run {

/// What tables need of one diagnosis.h5.
struct Diagnosis {
  std::string method;
  std::string ratio;
  std::int64_t seed = 0;
  std::int64_t generated_per_class = 0;
  double true_ratio = 0;
  std::string protocol;
  double accuracy = 0;  ///< in [0, 1]
};

/// All cells of a grid, or what is wrong with those that could not be had.
struct Results {
  std::vector<Diagnosis> diagnoses;               ///< by combination, then seed
  std::vector<scoring::QualityRecord> qualities;  ///< by method, then seed
  std::vector<std::string> problems;  ///< one line for each missing or refused file, with its cell
  Exit exit = Exit::done;  ///< for these problems: bad_input if any file is damaged or belongs
                           ///< elsewhere, else input_missing
};

/// One combination of the grid, or of a sweep around one of its methods.
struct Series {
  std::string name;    ///< in words: "method piae-dt", "batch 1"
  std::string folder;  ///< of its cells, within those of the seeds: "piae-dt", "sweep/batch-1"
  Combination combination;
};

/// Adds the diagnoses of a series, seed by seed, or what is wrong with them.
void collect_diagnoses(const Layout& layout, const Grid& grid, const Series& series,
                       Results& results);

/// Reads every cell, and goes on after one that cannot be read. A file is refused also when it
/// holds another cell than its place says, or when it was made under other conditions than those
/// before it (split protocol; counts at the same ratio; classes): a table would average what does
/// not belong together.
Results collect(const Layout& layout, const Grid& grid);

/// Adds a problem for each of these cells: they were made from what has changed since.
void refuse_outdated(const std::vector<std::filesystem::path>& files, Results& results);

/// A table with a hole in it is no table: logs a line for each problem, and throws an Error that
/// counts them.
void require_all(const Results& results);

}  // namespace piae::run

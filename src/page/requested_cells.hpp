#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/grid.hpp"
#include "run/started.hpp"

namespace piae::page {

/// Requested cells. An empty list stands for what the folder holds. A report also includes
/// everything else that the folder holds.
struct RequestedCells {
  std::vector<std::string> datasets = {};
  run::GridOptions cells = {};  ///< for each of the data sets
  /// Files that are out of date, relative to the folder of the run: "cwru/seed1/smote".
  std::vector<std::string> leave_out = {};

  /// Returns the names to leave out of one data set, relative to its folder.
  [[nodiscard]] std::vector<std::string> left_out_of(const std::string& dataset) const;
};

void bind(const cli::Options& command, RequestedCells& requested);

/// Returns the requested data sets and those of which the run holds more than what `make identify`
/// left, in alphabetical order. Throws Error(usage) if one is named twice, and Error(input_missing)
/// if there are none.
std::vector<std::string> datasets_of(const std::filesystem::path& run,
                                     const RequestedCells& requested);

/// Returns the requested cells of one data set; see run::Started::resolve(). Uses every ratio if
/// none is requested and none was started. Returns an empty grid if other data sets are requested
/// but not this one. Throws Error(usage) as run::resolve() does, and Error(input_missing) if
/// nothing is requested and the folder is empty.
run::Grid grid_of(const run::Started& started, const std::string& dataset,
                  const RequestedCells& requested);

}  // namespace piae::page

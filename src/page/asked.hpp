#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/grid.hpp"
#include "run/layout.hpp"

namespace piae::page {

/// Which cells there should be. A list that is empty stands for what the folder holds. A report is
/// of all that the folder holds besides, too.
struct AskedCells {
  std::vector<std::string> datasets = {};
  run::GridOptions cells = {};  ///< of each of them
  /// What is out of date, below the folder of the run: "cwru/seed1/smote".
  std::vector<std::string> leave_out = {};

  /// What is left out of one data set, below its folder.
  [[nodiscard]] std::vector<std::string> left_out_of(const std::string& dataset) const;
};

void bind(const cli::Options& command, AskedCells& asked);

/// The data sets that are asked for, and those of which the folder of the run holds more than what
/// `make identify` left, in alphabetical order. Throws Error(usage) for one that is named twice,
/// Error(input_missing) where there is none.
std::vector<std::string> datasets_of(const std::filesystem::path& run, const AskedCells& asked);

/// The cells of one data set that there should be, see run::resolve_begun(): of every ratio where
/// no ratio is asked for and none was begun. Nothing is asked for of a data set that is not among
/// those asked for. Throws Error(usage) as run::resolve() does, Error(input_missing) where nothing
/// is asked for and the folder holds nothing.
run::Grid grid_of(const run::Layout& layout, const std::string& dataset, const AskedCells& asked);

}  // namespace piae::page

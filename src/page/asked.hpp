#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/grid.hpp"
#include "run/layout.hpp"

namespace piae::page {

/// Which cells a report is of. A list that is empty stands for what the folder holds.
struct AskedCells {
  std::vector<std::string> datasets;
  std::vector<std::string> methods;
  std::vector<std::string> ratios;
  std::vector<std::string> seeds;
};

void bind(const cli::Options& command, AskedCells& asked);

/// The data sets that are asked for, or else those of which the folder of the run holds seeds, in
/// alphabetical order. Throws Error(usage) for one that is named twice, Error(input_missing) for a
/// folder that holds none.
std::vector<std::string> datasets_of(const std::filesystem::path& run, const AskedCells& asked);

/// The cells of one data set: what is asked for, or else every method, ratio and seed of which
/// there is a folder. A run that was only begun has a few folders and logs, and the cells that are
/// not yet there. Throws Error(usage) as run::resolve() does, Error(input_missing) where nothing is
/// asked for and the folder holds nothing.
run::Grid grid_of(const run::Layout& layout, const std::string& dataset, const AskedCells& asked);

}  // namespace piae::page

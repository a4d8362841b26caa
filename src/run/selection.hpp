#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "run/grid.hpp"

namespace piae::run {

/// Part of the grid, by the names that make and the folders use. An empty list stands for all.
struct Selection {
  std::vector<std::string> datasets = {};
  std::vector<std::string> methods = {};
  std::vector<std::string> ratios = {};
  std::vector<std::int64_t> seeds = {};
  std::vector<std::string> classifiers = {};

  [[nodiscard]] bool has_dataset(const std::string& dataset) const;
  /// True if a cell is selected. Ratio and classifier of a score are empty; a score is selected if
  /// any ratio with generated windows is, for every classifier. Throws Error(usage) if a selected
  /// ratio does not exist.
  [[nodiscard]] bool has(const Combination& cell, std::int64_t seed) const;
};

void bind(const cli::Options& command, Selection& selection);

}  // namespace piae::run

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/options.hpp"

namespace piae::run {

/// Part of the grid, by the names that make and the folders use. An empty list stands for all.
struct Selection {
  std::vector<std::string> datasets = {};
  std::vector<std::string> methods = {};
  std::vector<std::string> ratios = {};
  std::vector<std::int64_t> seeds = {};

  [[nodiscard]] bool has_dataset(const std::string& dataset) const;
  /// Whether a cell is selected. `ratio` is empty for a score; scores are selected where any ratio
  /// with generated windows is. Throws Error(usage) for a selected ratio that does not exist.
  [[nodiscard]] bool has(const std::string& method, const std::string& ratio,
                         std::int64_t seed) const;
};

void bind(const cli::Options& command, Selection& selection);

}  // namespace piae::run

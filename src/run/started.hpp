#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "run/collect.hpp"
#include "run/grid.hpp"
#include "run/layout.hpp"

namespace piae::run {

/// Binds --methods, --ratios, --seeds, --classifiers and --nothing-known for a program that shows
/// what a run holds. Each option may be left out.
void bind_started_cells(const cli::Options& command, GridOptions& options);

/// The cells of one data set that have started: their folders or logs exist.
class Started {
 public:
  explicit Started(Layout layout);

  [[nodiscard]] const Layout& layout() const { return layout_; }
  /// Returns the seeds, ascending.
  [[nodiscard]] const std::vector<std::int64_t>& seeds() const { return seeds_; }
  /// Returns the methods, in the order of the catalogue.
  [[nodiscard]] const std::vector<std::string>& methods() const { return methods_; }
  /// True if any diagnosis has started.
  [[nodiscard]] bool has_cells() const { return !ratios_of(methods_).empty(); }

  /// Returns the cells that should exist: the requested ones; an empty list stands for every
  /// started method, ratio, classifier or seed. Throws Error(usage) as run::resolve() does, and
  /// Error(input_missing) if nothing is requested and nothing has started.
  [[nodiscard]] Grid resolve(GridOptions options) const;

 private:
  [[nodiscard]] bool is_in_any_seed(const std::filesystem::path& below) const;
  [[nodiscard]] std::vector<std::string> ratios_of(const std::vector<std::string>& methods) const;
  /// Returns the classifiers with started cells. The cell of `none` by reference_classifier does
  /// not count, because naming any classifier adds it. Returns an empty list if no classifier was
  /// ever named.
  [[nodiscard]] std::vector<std::string> classifiers_of(
      const std::vector<std::string>& methods) const;
  [[nodiscard]] bool has_cells_by(const std::string& method, const std::string& classifier) const;
  /// True if the cell exists or its step has started. Its folder alone does not count: `make trust`
  /// keeps classifiers there without a diagnosis.
  [[nodiscard]] bool is_cell_started(const CellName& cell) const;

  Layout layout_;
  std::vector<std::int64_t> seeds_;
  std::vector<std::string> methods_;
};

}  // namespace piae::run

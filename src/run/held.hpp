#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "run/collect.hpp"
#include "run/grid.hpp"
#include "run/layout.hpp"

namespace piae::run {

/// Contents of a data set's folder in addition to the request. Tables use all of it, so that a
/// table of a part of the grid never replaces a fuller one.
class Held {
 public:
  /// `leave_out` names stale files, or folders with everything in them, below the dataset's folder,
  /// such as "seed1/smote".
  explicit Held(const Layout& layout, const std::vector<std::string>& leave_out = {});

  /// Counts only files that the folder of the other data set holds, too.
  Held(const Layout& layout, const Layout& other, const std::vector<std::string>& leave_out);

  /// True if a file of the folder exists and may be used.
  [[nodiscard]] bool has(const std::filesystem::path& file) const;
  /// True if a file of the folder exists and must be left out.
  [[nodiscard]] bool leaves_out(const std::filesystem::path& file) const;
  /// Returns the seeds that have a folder, ascending.
  [[nodiscard]] const std::vector<std::int64_t>& seeds() const { return seeds_; }

  /// Returns the seeds of a cell for tables, ascending: requested seeds, existing or not, and all
  /// other seeds whose file has() accepts. Seeds whose file leaves_out() reports are excluded.
  /// `file_of` returns the path for a seed.
  [[nodiscard]] std::vector<std::int64_t> seeds_with(
      const std::vector<std::int64_t>& requested,
      const std::function<std::filesystem::path(std::int64_t)>& file_of) const;

 private:
  [[nodiscard]] bool exists(const std::filesystem::path& file) const;

  std::vector<std::filesystem::path> folders_;  ///< its own, and the other data set's
  std::vector<std::int64_t> seeds_;
  std::vector<std::filesystem::path> left_out_;  ///< below any of the folders
};

void bind_leave_out(const cli::Options& command, std::vector<std::string>& leave_out);

/// Returns all methods, ratios and seeds with an existing or requested cell. Some combinations may
/// lack some seeds. Classifiers and methods are in the order of their catalogues. Reads no cell.
Grid held_grid(const Layout& layout, const Grid& requested, const Held& held);

/// Cells and their grid.
struct Collected {
  /// All methods, ratios and seeds with a cell. Some combinations may lack some seeds.
  Grid grid;
  Results results;
};

/// Reads the requested cells, as collect() does, and all others that the folder holds.
/// Results::left_out names the excluded ones. Classifiers and methods are in the order of their
/// catalogues, so the tables of the same cells are equal for every request. Diagnoses have
/// decisions if the folder holds the test windows (A) of their seed.
Collected collect_held(const Layout& layout, const Grid& requested, const Held& held,
                       const SeenCell& seen = {});

/// Classifiers whose cells are added to the requested ones.
enum class Classifiers { papers, all };

/// Reads the diagnoses without the scores.
Collected collect_held_diagnoses(const Layout& layout, const Grid& requested, const Held& held,
                                 Classifiers which = Classifiers::all);

/// Reads the scores only.
Results collect_held_scores(const Layout& layout, const Grid& requested, const Held& held);

/// Returns the models that infer stiffness and damping: requested ones, existing or not, and all
/// others that the folder holds together with the windows D of their seed. Sorted by method, then
/// seed; the ratio is empty.
std::vector<CellName> held_models(const Layout& layout, const Grid& requested, const Held& held);

}  // namespace piae::run

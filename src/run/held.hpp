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

/// What the folder of a dataset holds beside what is asked for. Tables are of all of it, so that
/// those asked for of a part of the grid never take the place of fuller ones.
class Held {
 public:
  /// `leave_out` names what is there but out of date: files, or folders with all that is in them,
  /// below the folder of the dataset, such as "seed1/smote".
  explicit Held(const Layout& layout, const std::vector<std::string>& leave_out = {});

  /// The same where only that counts which another dataset's folder holds, too.
  Held(const Layout& layout, const Layout& other, const std::vector<std::string>& leave_out);

  /// Whether a file of the folder is there and can be taken.
  [[nodiscard]] bool has(const std::filesystem::path& file) const;
  /// Whether a file of the folder is there and must be left out.
  [[nodiscard]] bool leaves_out(const std::filesystem::path& file) const;
  /// The seeds that have a folder, ascending.
  [[nodiscard]] const std::vector<std::int64_t>& seeds() const { return seeds_; }

  /// The seeds of a cell that tables are made of, ascending: those asked for, whether they are
  /// there or not, and all others of which has() its file; none that leaves_out() its file.
  /// `file_of` gives the path for a seed.
  [[nodiscard]] std::vector<std::int64_t> seeds_with(
      const std::vector<std::int64_t>& asked,
      const std::function<std::filesystem::path(std::int64_t)>& file_of) const;

 private:
  [[nodiscard]] bool exists(const std::filesystem::path& file) const;

  std::vector<std::filesystem::path> folders_;  ///< its own, and that of the other
  std::vector<std::int64_t> seeds_;
  std::vector<std::filesystem::path> left_out_;  ///< below any of the folders
};

void bind_leave_out(const cli::Options& command, std::vector<std::string>& leave_out);

/// All methods, ratios and seeds of which there is a cell, or one is asked for; not every
/// combination has every seed. Classifiers and methods are in the order of their
/// catalogues. No cell is read.
Grid held_grid(const Layout& layout, const Grid& asked, const Held& held);

/// Cells, and the grid that they are of.
struct Collected {
  /// All methods, ratios and seeds of which there is a cell; not every combination has every seed.
  Grid grid;
  Results results;
};

/// Reads the cells that are asked for, as collect() does, and with them all others that the folder
/// holds. What is left out is named in Results::left_out. Classifiers and
/// methods are in the order of their catalogues, so that the tables of the same cells are the same,
/// whoever asked. Diagnoses of seeds whose test windows (A) the folder holds have decisions.
Collected collect_held(const Layout& layout, const Grid& asked, const Held& held,
                       const SeenCell& seen = {});

/// Of which classifiers cells are looked for besides those that are asked for.
enum class Classifiers { papers, all };

/// The diagnoses alone, without the scores.
Collected collect_held_diagnoses(const Layout& layout, const Grid& asked, const Held& held,
                                 Classifiers which = Classifiers::all);

/// The scores alone.
Results collect_held_scores(const Layout& layout, const Grid& asked, const Held& held);

/// The models that infer stiffness and damping: those that are asked for, whether they are there or
/// not, and all others that the folder holds together with the windows D of their seed. By method,
/// then seed; the ratio is empty.
std::vector<CellName> held_models(const Layout& layout, const Grid& asked, const Held& held);

}  // namespace piae::run

#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "plan/due.hpp"
#include "plan/experiment.hpp"
#include "plan/grid_steps.hpp"
#include "plan/held_cells.hpp"
#include "plan/request.hpp"

namespace piae::plan {

/// The cells of one data set of a run behind a table.
struct TableCells {
  std::vector<std::string> files;  ///< chosen by with_held() (held_cells.hpp)
  std::vector<std::string>
      left_out;  ///< present but stale: files, or folders if everything in them is stale
};

/// Adds the steps of tables and the cells behind them. A table covers all cells that a run holds,
/// so that a request for a part never replaces the whole table. Stale cells that are not requested
/// are left out.
class TableSteps {
 public:
  TableSteps(const Experiment& experiment, const Choice& choice, GridSteps& grid, Judge& judge,
             Disk& disk)
      : experiment_(experiment), choice_(choice), grid_(grid), judge_(judge), disk_(disk) {}

  /// Adds the cells of the grid, without their tables.
  void cells();
  void features();
  void tables();

  [[nodiscard]] const Experiment& experiment() const { return experiment_; }
  [[nodiscard]] const Choice& choice() const { return choice_; }
  [[nodiscard]] GridSteps& grid() { return grid_; }
  [[nodiscard]] Judge& judge() { return judge_; }
  [[nodiscard]] Disk& disk() const { return disk_; }

  /// Returns the folder of a data set in the run.
  [[nodiscard]] std::string folder_of(const Dataset& dataset) const;

  /// Adds a table to those that are shown at the end.
  void show(const std::string& table) { shown_.push_back(table); }
  [[nodiscard]] const std::vector<std::string>& shown() const { return shown_; }

  /// Chooses cells of a data set.
  using Chosen = std::function<bool(const HeldCell&)>;
  /// Returns the requested cells, and all other chosen cells that the run holds. With `only_looks`,
  /// stale cells are taken if all of them are stale, since they then belong together.
  TableCells with_held(const Dataset& dataset, const std::vector<StepId>& requested,
                       const Chosen& chosen, bool only_looks = false);

  /// Adds a step of the grid for each requested cell of a part, and returns their outputs.
  using StepOfCell = StepId (GridSteps::*)(const Dataset& dataset, std::int64_t seed,
                                           const std::string& method, const std::string& ratio,
                                           const std::string& classifier);
  std::vector<std::string> add_for_cells(const Part& part, StepOfCell step_of_cell);

  /// Adds a step that makes no artefacts, with these files as inputs in one role.
  void add(Step step, const std::string& role, const std::vector<std::string>& files);
  /// Adds the picture that gnuplot draws of a table, or of several tables, which `csv` then joins.
  void add_picture(const std::string& csv, const std::vector<std::string>& joined = {});
  /// Returns the ratios of a table of moved settings: the given ones, else `otherwise`. Throws
  /// Error(usage) if none of them has generated windows.
  [[nodiscard]] std::vector<std::string> moved_ratios(const std::vector<std::string>& otherwise,
                                                      const std::string& goal) const;
  /// Return the options that select the requested cells: of a data set, and of all.
  [[nodiscard]] std::vector<std::string> selection(const Part& part) const;
  [[nodiscard]] std::vector<std::string> whole_selection() const;

 private:
  std::vector<StepId> cells_of(const Part& part);
  void add_tables(const Part& part);
  std::vector<StepId> without_missing(std::vector<StepId> requested,
                                      std::vector<std::string>& one_cell);
  const std::vector<HeldCell>& held(const Dataset& dataset);
  std::vector<std::pair<const HeldCell*, StepId>> held_steps(const Dataset& dataset,
                                                             const Chosen& chosen);
  StepId step_of(const Dataset& dataset, const HeldCell& cell);
  std::string name_of_left_out(const Dataset& dataset, const HeldCell& cell, StepId id);

  const Experiment& experiment_;
  const Choice& choice_;
  GridSteps& grid_;
  Judge& judge_;
  Disk& disk_;
  std::vector<std::string> shown_;
  std::map<std::string, std::vector<HeldCell>> held_;  ///< by data set
};

/// Returns the tables that the paper publishes. Throws Error(input_missing) if there are none.
Input input_of_published(Disk& disk);

/// Returns the name of the ratio without generated windows.
std::string nothing_generated();

}  // namespace piae::plan

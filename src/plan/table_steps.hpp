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

/// The cells of one data set of a run that a table is made of.
struct TableCells {
  std::vector<std::string> files;     ///< asked for, or there and up to date
  std::vector<std::string> left_out;  ///< there but out of date: files, or folders with all in them
};

/// Puts the steps of tables into a graph, and the cells that they are made of. Tables are of all
/// cells that a run holds, so that a part that is asked for never takes the place of the whole; of
/// cells that nobody asks for, those that are out of date are left out.
class TableSteps {
 public:
  TableSteps(const Experiment& experiment, const Choice& choice, GridSteps& grid, Judge& judge,
             Disk& disk)
      : experiment_(experiment), choice_(choice), grid_(grid), judge_(judge), disk_(disk) {}

  /// The cells of the grid; without their tables.
  void cells();
  void features();
  void tables();

  [[nodiscard]] const Experiment& experiment() const { return experiment_; }
  [[nodiscard]] const Choice& choice() const { return choice_; }
  [[nodiscard]] GridSteps& grid() { return grid_; }
  [[nodiscard]] Judge& judge() { return judge_; }
  [[nodiscard]] Disk& disk() const { return disk_; }

  /// The folder of a data set in the run.
  [[nodiscard]] std::string folder_of(const Dataset& dataset) const;

  /// Adds a table to those that people look at when all is done.
  void show(const std::string& table) { shown_.push_back(table); }
  [[nodiscard]] const std::vector<std::string>& shown() const { return shown_; }

  /// Chooses cells of a data set.
  using Chosen = std::function<bool(const HeldCell&)>;
  /// The cells that are asked for, and all other chosen ones that the run holds. With `only_looks`,
  /// where all of them are out of date, they are at least of one kind, and all are taken.
  TableCells with_held(const Dataset& dataset, const std::vector<StepId>& asked,
                       const Chosen& chosen, bool only_looks = false);

  /// Adds a step that makes no artefacts, of these files in one role.
  void add(Step step, const std::string& role, const std::vector<std::string>& files);
  /// Adds the picture that gnuplot draws of a table.
  void add_picture(const std::string& csv);
  /// The ratios of a table of settings that are moved: those given, else `otherwise`. Throws
  /// Error(usage) where nothing is generated at any of them.
  [[nodiscard]] std::vector<std::string> moved_ratios(const std::vector<std::string>& otherwise,
                                                      const std::string& goal) const;
  /// The options that name the cells asked for: of a data set, and of all.
  [[nodiscard]] std::vector<std::string> selection(const Part& part) const;
  [[nodiscard]] std::vector<std::string> whole_selection() const;

 private:
  std::vector<StepId> cells_of(const Part& part);
  void add_tables(const Part& part);
  std::vector<StepId> without_holes(std::vector<StepId> asked, std::vector<std::string>& one_cell);
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

/// The tables that the paper publishes. Throws Error(input_missing) where there are none.
Input input_of_published(Disk& disk);

/// The ratio at which nothing is generated.
std::string nothing_generated();

}  // namespace piae::plan

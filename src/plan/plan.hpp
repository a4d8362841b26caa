#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "plan/disk.hpp"
#include "plan/due.hpp"
#include "plan/experiment.hpp"
#include "plan/request.hpp"
#include "plan/step.hpp"

namespace piae::plan {

/// Parts of a run. Each is planned when the previous one is finished. A later part uses what
/// exists, so it is made even if an earlier part failed.
enum class Stretch {
  grid,      ///< cells, and tables without a missing cell
  numbers,   ///< of the figures, from what the run holds
  pictures,  ///< drawn from these numbers
  pages,     ///< report.html and the other pages
  shown,     ///< nothing left to do: the requested tables are shown
};
inline constexpr std::array stretches{Stretch::grid, Stretch::numbers, Stretch::pictures,
                                      Stretch::pages, Stretch::shown};
const char* to_string(Stretch stretch);
/// False if the goals have no step in a stretch: `cells` has none after the grid.
bool has_steps_in(Stretch stretch, const Choice& choice);

class TableSteps;

/// The steps of a request, and which of them are to be run.
class Plan {
 public:
  /// `disk` must outlive the plan. Throws as choose() does, and Error(usage) for a goal that cannot
  /// be made from what is requested.
  Plan(const Experiment& experiment, Choice choice, Stretch stretch, Disk& disk);

  [[nodiscard]] const Choice& choice() const { return choice_; }
  [[nodiscard]] const Graph& graph() const { return graph_; }
  [[nodiscard]] Judge& judge() { return *judge_; }
  /// Returns the requested steps, each after all steps that it needs.
  [[nodiscard]] std::vector<StepId> requested() const;
  /// Returns the requested steps that are not current; if cells are missing, tables only.
  [[nodiscard]] std::vector<StepId> to_run();
  /// Returns the steps of to_run() that make artefacts.
  [[nodiscard]] std::vector<StepId> missing();
  /// Returns the tables to be shown at the end.
  [[nodiscard]] const std::vector<std::string>& shown() const { return shown_; }
  /// Restricts the request to these files and everything that they are made from. Throws
  /// Error(usage) for a file that no step makes.
  void keep_only(const std::vector<std::string>& files);
  /// Does not request existing pages. Pages are rewritten on every make of a run, so an older page
  /// is not a gap in it.
  void keep_pages();

 private:
  void add_grid(TableSteps& tables);
  /// Adds these files, and everything that they are made from, to the request.
  void request_files(const std::vector<std::string>& files);

  Choice choice_;
  Graph graph_;
  std::unique_ptr<Judge> judge_;
  std::vector<std::string> shown_;
};

/// Plans with missing cells: tables of the grid use the existing cells, other tables use the
/// complete seeds. No step of the grid runs. Throws Error(input_missing) if no seed is complete.
std::unique_ptr<Plan> plan_with_missing(const Experiment& experiment, Choice choice, Disk& disk);

}  // namespace piae::plan

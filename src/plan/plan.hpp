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

/// Parts of a run, each planned when the one before is done. A later one takes what is there, and
/// is made also where an earlier one failed.
enum class Stretch {
  grid,      ///< cells, and the tables of which no cell is missing
  numbers,   ///< of figures, of what the run holds
  pictures,  ///< of the numbers that there are
  pages,     ///< report.html and its like
  shown,     ///< nothing more to be done: what was asked for is shown
};
inline constexpr std::array stretches{Stretch::grid, Stretch::numbers, Stretch::pictures,
                                      Stretch::pages, Stretch::shown};
const char* to_string(Stretch stretch);
/// False where the goals have no step in a stretch, as `cells` has none behind the grid.
bool has_steps_in(Stretch stretch, const Choice& choice);

class TableSteps;

/// The steps for what is asked, and which of them are to be run.
class Plan {
 public:
  /// `disk` must live as long as the plan. Throws as choose() does, and Error(usage) for a goal
  /// that cannot be made with what is asked for.
  Plan(const Experiment& experiment, Choice choice, Stretch stretch, Disk& disk);

  [[nodiscard]] const Choice& choice() const { return choice_; }
  [[nodiscard]] const Graph& graph() const { return graph_; }
  [[nodiscard]] Judge& judge() { return *judge_; }
  /// The steps that are asked for, each behind all that it waits for.
  [[nodiscard]] std::vector<StepId> asked() const;
  /// Those of them that are not current; where there are holes, tables alone.
  [[nodiscard]] std::vector<StepId> to_run();
  /// The steps among them that make artefacts.
  [[nodiscard]] std::vector<StepId> missing();
  /// The tables to be shown when all is done.
  [[nodiscard]] const std::vector<std::string>& shown() const { return shown_; }
  /// Restricts what is asked to these files and what they are made of. Throws Error(usage) for a
  /// file that no step makes.
  void keep_only(const std::vector<std::string>& files);
  /// Asks for no page that is there: pages are written anew whenever a run is made, which is
  /// nothing that it lacks.
  void keep_pages();

 private:
  void add_grid(TableSteps& tables);
  /// Asks for these files and what they are made of, in addition to what is asked already.
  void ask_for(const std::vector<std::string>& files);

  Choice choice_;
  Graph graph_;
  std::unique_ptr<Judge> judge_;
  std::vector<std::string> shown_;
};

/// The same where cells are missing: the tables of the grid are of the cells that are there, other
/// tables of the seeds of which nothing is missing. Nothing of the grid is made. Throws
/// Error(input_missing) where there is no such seed.
std::unique_ptr<Plan> plan_with_holes(const Experiment& experiment, Choice choice, Disk& disk);

}  // namespace piae::plan

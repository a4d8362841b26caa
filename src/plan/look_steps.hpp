#pragma once

#include <string>
#include <vector>

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Puts the steps into a graph that show what a run holds, whatever that is: nothing of the grid is
/// made for them.
class LookSteps {
 public:
  LookSteps(const Choice& choice, GridSteps& grid, TableSteps& tables)
      : choice_(choice), grid_(grid), tables_(tables) {}

  /// The numbers of the figures, as CSV. Throws Error(input_missing) where a run is only looked at
  /// and holds nothing of what is asked for.
  void numbers();
  /// The pictures that gnuplot draws of them.
  void pictures();
  /// report.html, report.md and run.html.
  void pages(const Experiment& experiment);

 private:
  std::vector<std::string> left_out(const Dataset& dataset);
  [[nodiscard]] std::vector<std::string> must_be_there(const Part& part) const;

  const Choice& choice_;
  GridSteps& grid_;
  TableSteps& tables_;
};

}  // namespace piae::plan

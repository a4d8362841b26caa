#pragma once

#include <string>
#include <vector>

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Adds the steps that show what a run holds. They never cause a step of the grid to run.
class LookSteps {
 public:
  LookSteps(const Choice& choice, GridSteps& grid, TableSteps& tables)
      : choice_(choice), grid_(grid), tables_(tables) {}

  /// Adds the numbers of the figures, as CSV. Throws Error(input_missing) if a run is only viewed
  /// and holds nothing that was requested.
  void numbers();
  /// Adds the pictures that gnuplot draws from these numbers.
  void pictures();
  /// Adds report.html, report.md and run.html.
  void pages(const Experiment& experiment);

 private:
  std::vector<std::string> left_out(const Dataset& dataset);
  [[nodiscard]] std::vector<std::string> must_be_there(const Part& part) const;

  const Choice& choice_;
  GridSteps& grid_;
  TableSteps& tables_;
};

}  // namespace piae::plan

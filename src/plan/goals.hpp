#pragma once

#include <string>
#include <vector>

#include "plan/table_steps.hpp"

namespace piae::plan {

/// A word that make takes, and the steps that it stands for.
struct Goal {
  std::string name;
  /// Adds its steps to the graph; null for a goal that only looks at what a run holds.
  void (*add)(TableSteps& tables) = nullptr;
  /// The logs of the steps that `make status` counts; none where it does not take the goal.
  std::vector<std::string> counts = {};
  bool is_submitted = false;  ///< `make cluster` submits it
  bool draws = false;         ///< it ends with the figures of what the run holds then
  bool writes_pages = false;  ///< and with report.html and its like
  /// The names of its files, or of folders in that of a seed or a data set, begin so.
  std::vector<std::string> beginnings = {};
};

/// All goals, in the order in which their steps are added.
const std::vector<Goal>& goals();

std::vector<std::string> goal_names();

/// The goal of a name that there is.
const Goal& goal_named(const std::string& name);

/// The goal that a file of a run belongs to.
const Goal& goal_of_file(const std::string& file);

/// Requires exactly one goal, for which `is_so` holds. Throws Error(usage) with those there are.
void require_one_that(bool (*is_so)(const Goal&), const std::vector<std::string>& names);

}  // namespace piae::plan

#pragma once

#include <string>
#include <vector>

#include "plan/table_steps.hpp"

namespace piae::plan {

/// A goal of make, and the steps that it stands for.
struct Goal {
  std::string name;
  /// Adds its steps to the graph; null for a goal that only shows what a run holds.
  void (*add)(TableSteps& tables) = nullptr;
  /// Logs of the steps that `make status` counts; empty if status does not take the goal.
  std::vector<std::string> counts = {};
  bool is_submitted = false;  ///< true if `make cluster` submits it
  bool draws = false;         ///< true if it ends with the figures of what the run holds
  bool writes_pages = false;  ///< true if it ends with report.html and the other pages
  /// Beginnings of the names of its files, or of its folders in the folder of a seed or data set.
  std::vector<std::string> beginnings = {};
};

/// Returns all goals, in the order in which their steps are added.
const std::vector<Goal>& goals();

std::vector<std::string> goal_names();

/// Returns the goal of an existing name.
const Goal& goal_named(const std::string& name);

/// Returns the goal that a file of a run belongs to.
const Goal& goal_of_file(const std::string& file);

/// Requires exactly one goal for which `is_so` is true. Else throws Error(usage) with the possible
/// ones.
void require_one_that(bool (*is_so)(const Goal&), const std::vector<std::string>& names);

}  // namespace piae::plan

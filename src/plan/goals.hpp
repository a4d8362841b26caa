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
  bool is_counted = false;    ///< `make status` counts its cells, or models
  bool is_submitted = false;  ///< `make cluster` submits it
  /// The names of its files, and of folders in that of a seed, begin so.
  std::vector<std::string> beginnings = {};
};

/// All goals, in the order in which their steps are added.
const std::vector<Goal>& goals();

std::vector<std::string> goal_names();

/// The goal that a file of a run belongs to.
const Goal& goal_of_file(const std::string& file);

/// Requires exactly one goal, for which `is_so` holds. Throws Error(usage) with those there are.
void require_one_that(bool Goal::*is_so, const std::vector<std::string>& names);

}  // namespace piae::plan

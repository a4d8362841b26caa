#pragma once

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Adds the tables of [sweep] and their cells: each point moves one setting of a method. Points at
/// the method's own settings are its cells of the grid.
///
///     <dataset>/seedK/sweep/batch-1/..., <dataset>/sweep.{csv,md}; sweep@METHOD of other methods
void add_sweeps(TableSteps& tables);

}  // namespace piae::plan

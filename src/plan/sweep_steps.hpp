#pragma once

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Puts the tables of [sweep] into a graph, and their cells: each point moves one setting of a
/// method. The points that the method has anyway are its cells of the grid.
///
///     <dataset>/seedK/sweep/batch-1/..., <dataset>/sweep.{csv,md}; sweep@METHOD of other methods
void add_sweeps(TableSteps& tables);

}  // namespace piae::plan

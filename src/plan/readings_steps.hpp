#pragma once

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Puts the table of [readings] into a graph, and its cells: the paper's method with the settings
/// of the base, but for those that a reading names.
///
///     <dataset>/seedK/readings/batches-class/..., <dataset>/readings.{csv,md,svg,pdf}
void add_readings(TableSteps& tables);

}  // namespace piae::plan

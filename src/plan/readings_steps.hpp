#pragma once

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Adds the table of [readings] and its cells: the paper's method with the settings of the base,
/// except for those that an interpretation changes.
///
///     <dataset>/seedK/readings/batches-class/..., <dataset>/readings.{csv,md,svg,pdf}
void add_readings(TableSteps& tables);

}  // namespace piae::plan

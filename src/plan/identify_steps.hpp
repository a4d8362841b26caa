#pragma once

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Puts the tables into a graph that compare the (k, c) of the twin with the true ones, and the
/// models that they are of. Throws Error(usage) where no data set that is asked for is simulated.
///
///     <dataset>/identifiability.{csv,md}, scatter.csv
void add_identifications(TableSteps& tables);

}  // namespace piae::plan

#pragma once

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Adds the tables that compare the twin's (k, c) with the true ones, and the models behind them.
/// Throws Error(usage) if none of the requested data sets is simulated.
///
///     <dataset>/identifiability.{csv,md}, scatter.csv
void add_identifications(TableSteps& tables);

}  // namespace piae::plan

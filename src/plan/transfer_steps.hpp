#pragma once

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Adds the tables of the groups of [transfer], means over data sets that test another speed or
/// size, and their cells: those at the ratio with the most generated windows.
///
///     RUN/transfer@GROUP.{csv,md,svg,pdf}, transfer-comparisons@GROUP.csv
///     RUN/rigs.{csv,svg,pdf}, one picture of all groups, if there are several
void add_transfers(TableSteps& tables);

}  // namespace piae::plan

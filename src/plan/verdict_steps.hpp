#pragma once

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Adds the verdicts of kept classifiers on each record, their table, and its picture.
void add_verdicts(TableSteps& tables);

}  // namespace piae::plan

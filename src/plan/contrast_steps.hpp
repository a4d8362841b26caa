#pragma once

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Adds the tables that compare two runs, which differ in one condition, and the cells of both
/// runs:
///
///     RUN and RUN-blocked      -> <dataset>/protocols.md      the overlap of windows in a random
///     split cwru-as-published, cwru  -> cwru-as-published/rates.md  the mixed sample rates
void add_contrasts(TableSteps& tables);

}  // namespace piae::plan

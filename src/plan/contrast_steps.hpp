#pragma once

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Puts the tables into a graph that set two runs side by side which differ in one condition, and
/// the cells of both:
///
///     RUN and RUN-blocked      -> <dataset>/protocols.md      the overlap of windows in a random
///     split cwru-as-published, cwru  -> cwru-as-published/rates.md  the mixed sample rates
void add_contrasts(TableSteps& tables);

}  // namespace piae::plan

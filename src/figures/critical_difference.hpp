#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns Demsar's critical-difference diagram (2006, Section 3.2.2 and Fig. 1) for each ratio at
/// which all methods have a cell: the ranks of the methods within each seed. Columns:
/// ratio,kind,method,place,rank,rank_to,seeds,friedman_p,critical_difference. Rows of `kind`
/// "method" come best first, with their `place`. Rows of kind "alike" are bars from `rank` to
/// `rank_to` over the largest groups of methods of which no two differ by more than the critical
/// difference. Their `place` is the row in which a bar is drawn. A single seed has no test, and no
/// bars.
Numbers critical_differences(Source& source, const report::ClassifierRows& shown);

}  // namespace piae::figures

#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Demsar's critical-difference diagram (2006, Section 3.2.2 and Fig. 1) of each ratio at which all
/// methods have a cell: how the methods rank among those of the same seed. Columns:
/// ratio,kind,method,place,rank,rank_to,seeds,friedman_p,critical_difference. Rows of `kind`
/// "method" come best first, with their `place`; those of kind "alike" are bars from `rank` to
/// `rank_to`, each over methods of which no two differ by more than the critical difference, and
/// over as many as can be. Their `place` is the row in which a bar is drawn. A single seed has no
/// test, and no bars.
Numbers critical_differences(Source& source, const report::ClassifierRows& shown);

}  // namespace piae::figures

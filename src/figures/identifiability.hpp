#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns the stiffness and damping that methods infer of unseen windows, against the true ones,
/// as compared by the stage `identify`. Columns:
/// method,parameter,truth_low,truth_high,windows,inferred_p10,inferred_p50,inferred_p90,r2 in N/m
/// and N s/m. Windows are grouped by their true value; each group has the median of its inferred
/// values and the limits of their middle 80 %. `r2` is over all windows of a seed, averaged over
/// the seeds. Throws Error(input_missing) if the windows of the data set are not simulated.
Numbers identifiability(Source& source);

}  // namespace piae::figures

#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// The stiffness and damping that methods infer of windows that they have not seen, against the
/// true ones, as the stage `identify` compared them. Columns:
/// method,parameter,truth_low,truth_high, windows,inferred_p10,inferred_p50,inferred_p90,r2 in N/m
/// and N s/m: windows in groups by their true value, and of what was inferred in each group the
/// median and between what 80 % lie. `r2` is that of all windows of a seed in the mean over the
/// seeds. Throws Error(input_missing) where the windows of the dataset are not simulated.
Numbers identifiability(Source& source);

}  // namespace piae::figures

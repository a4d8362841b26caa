#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns the effect of overlapping windows: the accuracies of this run, with a random split, and
/// of the run next to it whose name ends in "-blocked", with a blocked split, for the methods,
/// ratios and seeds of the grid that the blocked run has started. Columns:
/// method,ceiling,ratio,protocol,seed,accuracy,low,high, in percent; `seed` is "mean" for the mean
/// over the seeds, which alone has a 95 % interval (empty for fewer than three seeds). Throws
/// LeftOut without such a run, and Error(bad_input) for two runs with the same protocol.
Numbers protocols(Source& source);

}  // namespace piae::figures

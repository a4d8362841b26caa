#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns the effect of overlapping windows: accuracies of this run, whose split is random, and of
/// the run with the suffix "-blocked", whose split is blocked. It covers the methods, ratios and
/// seeds that the blocked run has started. Columns:
/// method,ceiling,ratio,protocol,seed,accuracy,low,high, in percent; `seed` is "mean" for the mean
/// over the seeds, which alone has a 95 % interval (empty for fewer than three seeds). Throws
/// LeftOut without such a run, and Error(bad_input) for two runs with the same protocol.
Numbers protocols(Source& source);

}  // namespace piae::figures

#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// What overlapping windows are worth: the accuracies of this run, whose split is random, beside
/// those of the run beside it whose name ends in "-blocked" and whose split is blocked, of the
/// methods, ratios and seeds of the grid that the latter has begun. Columns:
/// method,ceiling,ratio,protocol,seed,accuracy,low,high, in percent; `seed` is "mean" for the mean
/// over the seeds, which alone has a 95 % interval (empty for fewer than three seeds). Throws
/// LeftOut where there is no such run, and Error(bad_input) for two runs of the same
/// kind of split.
Numbers protocols(Source& source);

}  // namespace piae::figures

#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns the accuracy of each method minus that of the method of interest at the same seed, in
/// points, at each ratio and averaged over ratios (ratio "mean"). The method of interest is this
/// project's or else the paper's. Columns:
/// method,ceiling,ratio,against,seed,difference,low,high,p,p_holm,least_p. Each seed has a row; a
/// row with the seed "mean" follows. Only this row has the 95 % interval of the mean (empty for
/// fewer than three seeds) and p of Wilcoxon's test. `p_holm` is corrected over the methods of the
/// ratio; `least_p` is the smallest `p_holm` possible with this number of seeds. A single seed has
/// no p.
Numbers paired_differences(Source& source, const report::ClassifierRows& shown);

}  // namespace piae::figures

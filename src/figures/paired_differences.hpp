#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// The accuracy of each method minus that of the same seed by the method of interest, which is this
/// project's or else the paper's, in points, at each ratio and in the mean of ratios (ratio
/// "mean"). Columns: method,ceiling,ratio,against,seed,difference,low,high,p,p_holm,least_p. For
/// each seed a row, then one whose seed is "mean", with the 95 % interval of the mean (empty for
/// fewer than three seeds), p of Wilcoxon's test, p after Holm's correction over the methods of
/// that ratio, and the smallest that so many seeds can make the latter. A single seed has no p.
Numbers paired_differences(Source& source, const report::ClassifierRows& shown);

}  // namespace piae::figures

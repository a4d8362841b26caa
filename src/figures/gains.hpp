#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns Fig. 15: the gain of generated windows over none, in points, by ratio. Columns:
/// method,ceiling,ratio,generated_per_class,seed,gain,low,high,published. Each seed has a row with
/// its gain; a row with the seed "mean" follows, with the 95 % interval of the mean (empty for
/// fewer than three seeds) and the published value for this data set or its counterpart.
Numbers gains_of_methods(Source& source, const report::ClassifierRows& shown);

/// Returns Fig. 18: the same for the paper's models, those of its outlook, and the ceiling.
Numbers gains_of_models(Source& source, const report::ClassifierRows& shown);

/// Returns the accuracies, with the same columns, of all methods of the grid; `none` has one row
/// for each seed, without generated windows. So has the baseline (report/accuracies.hpp), if
/// known; its method is the name of its classifier.
Numbers accuracies(Source& source, const report::ClassifierRows& shown);

}  // namespace piae::figures

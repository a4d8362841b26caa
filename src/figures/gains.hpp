#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Fig. 15: what generated windows gain over none, in points, by ratio. Columns:
/// method,ceiling,ratio,generated_per_class,seed,gain,low,high,published; for each seed a row with
/// its gain, then one whose seed is "mean", with the 95 % interval of the mean (empty for fewer
/// than three seeds) and what the paper publishes of this dataset or of its counterpart.
Numbers gains_of_methods(Source& source, const report::ClassifierRows& shown);

/// Fig. 18: the same of the paper's models and those of its outlook, and the ceiling.
Numbers gains_of_models(Source& source, const report::ClassifierRows& shown);

/// The accuracies themselves, with the same columns, of all methods of the grid; `none` has one row
/// for each seed, with no generated windows. So has the bar (report/classifier_rows.hpp), where it
/// is known; its method is the name of its classifier.
Numbers accuracies(Source& source, const report::ClassifierRows& shown);

}  // namespace piae::figures

#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns the precision if only the most certain test windows get a prediction, for each method at
/// its ratio with the most generated windows, and for the baseline: the mean over the seeds at each
/// percent of the windows (scoring/refusal.hpp). Columns: method,ceiling,ratio,answered,precision,
/// the last two in percent. The baseline has the name of its classifier as method.
Numbers refusals(Source& source, const report::ClassifierRows& shown);

}  // namespace piae::figures

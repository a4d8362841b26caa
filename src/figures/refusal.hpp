#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// How often the answers are right where only the surest test windows are answered, of each method
/// at its ratio with the most generated windows, and of the bar: the mean over the seeds at each
/// percent of the windows (scoring/refusal.hpp). Columns: method,ceiling,ratio,answered,precision,
/// the last two in percent. The bar has the name of its classifier in the place of a method's.
Numbers refusals(Source& source, const report::ClassifierRows& shown);

}  // namespace piae::figures

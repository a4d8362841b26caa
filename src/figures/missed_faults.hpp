#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns the errors that cost a plant money: faults predicted as healthy, and healthy windows
/// predicted as faults, for each method at its ratio with the most generated windows. Columns:
/// method,ceiling,ratio,kind,class,seed,percent; `seed` is "mean" for the mean over the seeds.
/// `kind` is "all-faults" for missed windows of all fault classes together, "fault" for those of
/// one `class`, and "healthy" for false alarms. A class without test windows has no rows.
Numbers missed_faults(Source& source);

}  // namespace piae::figures

#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns confusion matrices summed over the seeds, for each method at its ratio with the most
/// generated windows. Columns: method,ceiling,ratio,truth,predicted,windows,percent; `percent` is
/// the share of the windows of class `truth`. A class without test windows has no rows.
Numbers confusions(Source& source);

}  // namespace piae::figures

#pragma once

#include <string>

#include "regression/deviations.hpp"

namespace piae::regression {

/// Returns a text for people: the settings of both sides and the tolerance, a table of the moved
/// rows, the cells that one side lacks, and a line of counts.
std::string deviations_text(const Measurements& reference, const Measurements& run,
                            Tolerance tolerance, const Deviations& deviations);

}  // namespace piae::regression

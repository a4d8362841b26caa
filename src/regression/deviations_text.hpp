#pragma once

#include <string>

#include "regression/deviations.hpp"

namespace piae::regression {

/// For people: by which tolerance and why, a table of what moved, the cells that are on one side
/// only, and a line that counts.
std::string deviations_text(const Measurements& reference, const Measurements& run,
                            Tolerance tolerance, const Deviations& deviations);

}  // namespace piae::regression

#pragma once

#include <string>

#include "regression/deviations.hpp"

namespace piae::regression {

/// What people read: with what both sides were made and by which tolerance they were compared, a
/// table of what moved, the cells that one side lacks, and a line that counts.
std::string deviations_text(const Measurements& reference, const Measurements& run,
                            Tolerance tolerance, const Deviations& deviations);

}  // namespace piae::regression

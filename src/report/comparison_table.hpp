#pragma once

#include <string>

#include "report/comparison.hpp"

namespace piae::report {

/// For people: by which tolerance and why, a table of what moved, the cells that are on one side
/// only, and a line that counts.
std::string comparison_text(const Measurements& reference, const Measurements& run,
                            Tolerance tolerance, const Comparison& comparison);

}  // namespace piae::report

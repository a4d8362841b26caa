#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "run/collect.hpp"
#include "run/grid.hpp"

namespace piae::report {

/// Returns "3", "0 to 9" or "0 to 2, 5".
std::string seed_list(const std::vector<std::int64_t>& seeds);

/// Returns a paragraph for each kind of gap in a run: methods that lack ratios or seeds, methods
/// with few scores, and cells that were left out because they are out of date. Returns none if
/// every method has every cell.
std::vector<std::string> gap_paragraphs(const run::Grid& grid, const run::Results& results);

/// Returns the paragraph on left-out cells as one line for a terminal; "" if none was left out.
std::string left_out_line(const run::Results& results);

}  // namespace piae::report

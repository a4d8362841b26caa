#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "run/collect.hpp"
#include "run/grid.hpp"

namespace piae::report {

/// "3", "0 to 9", "0 to 2, 5".
std::string seed_list(const std::vector<std::int64_t>& seeds);

/// What a run that holds more of some methods than of others lets its reader know, a paragraph
/// each: which methods have not all ratios and seeds, and which cells were left out because they
/// are out of date. None where every method has every cell.
std::vector<std::string> gap_paragraphs(const run::Grid& grid, const run::Results& results);

/// The second of them as one line for a terminal; empty where nothing was left out.
std::string left_out_line(const run::Results& results);

}  // namespace piae::report

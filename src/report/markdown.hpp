#pragma once

#include <string>
#include <vector>

#include "report/accuracy_table.hpp"

namespace piae::report {

/// tables.md: the paper's Table 6 (without augmentation: each seed, mean, interval) and Table 8
/// (method by ratio), or what corresponds to them for another dataset, with the published figures
/// below ours. `rows` has at least one; `results` are what they were made from.
std::string tables_markdown(const Grid& grid, const Results& results,
                            const std::vector<AccuracyRow>& rows, const Published& published);

}  // namespace piae::report

#pragma once

#include <string>
#include <vector>

#include "report/accuracy_table.hpp"
#include "run/collect.hpp"
#include "run/grid.hpp"

namespace piae::report {

/// What a person wants to know first of a run, at most 80 columns wide: a table with the mean
/// accuracy of each method at each ratio, a sentence that says which methods help and by how many
/// points at the ratio with the most generated windows, and one that says why the paper's method,
/// where it is in the grid and does not help, does not. All numbers are those of the run. `rows`
/// are accuracy_rows() of these results.
std::string summary_text(const run::Grid& grid, const run::Results& results,
                         const std::vector<AccuracyRow>& rows);

}  // namespace piae::report

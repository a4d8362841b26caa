#pragma once

#include <vector>

#include "report/accuracy_table.hpp"
#include "report/document.hpp"

namespace piae::report {

/// Tables 6-11 of the paper and the gains behind its Figs 15 and 18, or what corresponds to them
/// for another dataset, with the published figures below ours: without augmentation (a run a
/// column), then accuracies and gains of the compared methods, then those of the ablations (a ratio
/// a column). A table without a row is left out. `rows` are of accuracy_rows.
std::vector<Section> accuracy_sections(const run::Grid& grid, const std::vector<AccuracyRow>& rows,
                                       const Published& published);

}  // namespace piae::report

#pragma once

#include <vector>

#include "report/accuracy_table.hpp"
#include "report/document.hpp"

namespace piae::report {

/// Tables 6 to 11 of the paper and the gains that it draws in Figs 15 and 18, or the same for
/// another dataset, with the published numbers below ours. The first table is without generated
/// windows and has a run in each column. Then come accuracies and gains of the compared methods,
/// and those of the ablations, with a ratio in each column. Tables without a row are left out.
/// `rows` are of accuracy_rows().
std::vector<Section> accuracy_sections(const run::Grid& grid, const std::vector<AccuracyRow>& rows,
                                       const Published& published);

}  // namespace piae::report

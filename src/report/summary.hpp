#pragma once

#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "report/document.hpp"
#include "run/collect.hpp"
#include "run/grid.hpp"

namespace piae::report {

/// Returns the first things to know of a run, at most 80 columns wide. For each classifier, a table
/// has the mean accuracy of each method at each ratio. Then come the tested conditions and the
/// accuracy by fault type (report/verdict.hpp). A sentence reports which methods help, and by how
/// many points, at the ratio with the most generated windows. If the grid has the paper's method
/// and it does not help, a second sentence explains why. Last comes the recommended method
/// (report/recommendation.hpp). All numbers come from the run. `rows` are accuracy_rows() of
/// `results`.
std::string summary_text(const run::Grid& grid, const run::Results& results,
                         const std::vector<AccuracyRow>& rows);

/// Returns the same for report.md, a section for each classifier: the mean accuracy of each method
/// at each ratio, next to the published numbers. `seeds` is the number of seeds of the run.
std::vector<Section> overview_sections(const std::vector<AccuracyRow>& rows, std::size_t seeds);

}  // namespace piae::report

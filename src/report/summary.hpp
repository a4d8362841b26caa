#pragma once

#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "report/document.hpp"
#include "run/collect.hpp"
#include "run/grid.hpp"

namespace piae::report {

/// What a person wants to know first of a run, at most 80 columns wide: a table with the mean
/// accuracy of each method at each ratio, for each classifier, what faults known in other
/// conditions are tested in and how often their kind is right (report/verdict.hpp), and a
/// sentence that says which methods help and by how many points at the ratio with the most
/// generated windows. Where the paper's method is in the grid and does not help, a second sentence
/// says why. Last comes which method to take (report/recommendation.hpp). All numbers are those of
/// the run. `rows` are accuracy_rows() of these results.
std::string summary_text(const run::Grid& grid, const run::Results& results,
                         const std::vector<AccuracyRow>& rows);

/// The same for report.md, a section for each classifier: the mean accuracy of each method at each
/// ratio, next to what the paper publishes. `seeds` are those of the run.
std::vector<Section> overview_sections(const std::vector<AccuracyRow>& rows, std::size_t seeds);

}  // namespace piae::report

#pragma once

#include <vector>

#include "report/accuracies.hpp"
#include "report/document.hpp"

namespace piae::report {

/// For a page: which share of the windows of each class is recognised by the paper's classifier
/// with the windows of each method, summed over seeds, with missed faults and false alarms. Methods
/// are at that of the ratios with the most of them which has the most generated windows. No section
/// where there is no such cell. `rows` are accuracy_rows() of these results.
std::vector<Section> recall_sections(const std::vector<AccuracyRow>& rows,
                                     const run::Results& results);

}  // namespace piae::report

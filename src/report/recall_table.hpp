#pragma once

#include <vector>

#include "report/accuracies.hpp"
#include "report/document.hpp"

namespace piae::report {

/// Returns for a page the recall of each class, missed faults and false alarms, summed over seeds.
/// The classifier is the paper's, trained with the windows of each method. The ratio is the one
/// with the most methods; if several, the one with the most generated windows. Returns no section
/// if the paper's classifier has no cell. `rows` are accuracy_rows() of `results`.
std::vector<Section> recall_sections(const std::vector<AccuracyRow>& rows,
                                     const run::Results& results);

}  // namespace piae::report

#pragma once

#include <vector>

#include "report/accuracies.hpp"
#include "report/document.hpp"

namespace piae::report {

/// Returns for a page the share of each class's windows that the paper's classifier recognises with
/// the windows of each method, summed over seeds, with missed faults and false alarms. The ratio is
/// the one with the most methods; if several, the one with the most generated windows. Returns no
/// section if the paper's classifier has no cell. `rows` are accuracy_rows() of `results`.
std::vector<Section> recall_sections(const std::vector<AccuracyRow>& rows,
                                     const run::Results& results);

}  // namespace piae::report

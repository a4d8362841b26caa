#pragma once

#include <vector>

#include "report/accuracies.hpp"
#include "report/comparisons.hpp"
#include "report/document.hpp"
#include "report/rank_table.hpp"

namespace piae::report {

/// Returns all tables of a data set. For each classifier: accuracies and gains, next to the
/// published numbers of this data set or its counterpart; comparisons, ranks, decisions over
/// several windows and confidence. Then come quality, `twins` (twin_table.hpp) and the recommended
/// method (recommendation_tables.hpp). If there are several classifiers, each title names its own.
/// `rows`, at least one, were made from `results`; `comparisons` and `ranks` were made from `rows`.
Document tables(const run::Grid& grid, const run::Results& results,
                const std::vector<AccuracyRow>& rows, const Published& published,
                const std::vector<Comparisons>& comparisons, const std::vector<RankTable>& ranks,
                const std::vector<Section>& twins = {});

}  // namespace piae::report

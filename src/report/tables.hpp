#pragma once

#include <vector>

#include "report/accuracies.hpp"
#include "report/comparisons.hpp"
#include "report/document.hpp"
#include "report/rank_table.hpp"

namespace piae::report {

/// All tables of a dataset: accuracies and gains, beside what the paper publishes of this dataset
/// or of its counterpart, comparisons and ranks, decisions over several windows and confidence, for
/// each classifier; then quality. Where there are several classifiers, the title of each table says
/// which it is of. `rows`, at least one, were made from `results`; `comparisons` and `ranks` were
/// made from `rows`. `twins` (twin_table.hpp) follow. Last comes which method to take
/// (recommendation_tables.hpp).
Document tables(const run::Grid& grid, const run::Results& results,
                const std::vector<AccuracyRow>& rows, const Published& published,
                const std::vector<Comparisons>& comparisons, const std::vector<RankTable>& ranks,
                const std::vector<Section>& twins = {});

}  // namespace piae::report

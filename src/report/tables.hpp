#pragma once

#include <vector>

#include "report/accuracy_table.hpp"
#include "report/document.hpp"
#include "report/rank_table.hpp"
#include "report/significance.hpp"

namespace piae::report {

/// All tables of a dataset: accuracies and gains beside what the paper publishes, or what it
/// publishes of the dataset that this one stands in for; comparisons, ranks and quality. `rows` has
/// at least one; `results` are what they were made from, `comparisons` and `ranks` are made from
/// them.
Document tables(const run::Grid& grid, const run::Results& results,
                const std::vector<AccuracyRow>& rows, const Published& published,
                const Comparisons& comparisons, const RankTable& ranks);

}  // namespace piae::report

#pragma once

#include <string>
#include <vector>

#include "report/document.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// Returns quality.csv: dataset,method,class,metric,seeds,mean,std over the seeds. `results` must
/// have all cells of the grid. scoring/quality.hpp defines the metrics. The standard deviation of a
/// single seed is empty.
std::string quality_csv(const run::Grid& grid, const run::Results& results);

/// Returns the numbers of Figs 13 and 14 (methods) and 16 and 17 (ablations): a table for each
/// metric, with a class in each row, a method in each column, and the mean over the classes in the
/// last row.
std::vector<Section> quality_sections(const run::Grid& grid, const run::Results& results);

}  // namespace piae::report

#pragma once

#include <string>
#include <vector>

#include "report/document.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// quality.csv: dataset,method,class,metric,seeds,mean,std over the seeds of a grid, all of whose
/// cells `results` has. Metrics are those of scoring/quality.hpp; std of one seed alone is empty.
std::string quality_csv(const run::Grid& grid, const run::Results& results);

/// What the paper shows in its Figs 13 and 14 (methods), 16 and 17 (ablations): a table for each
/// metric, a class a row, a method a column, and at the end the mean over the classes.
std::vector<Section> quality_sections(const run::Grid& grid, const run::Results& results);

}  // namespace piae::report

#pragma once

#include <string>

#include "report/collect.hpp"

namespace piae::report {

/// quality.csv: dataset,method,class,metric,seeds,mean,std over the seeds of a grid, all of whose
/// cells `results` has. Metrics are those of scoring/quality.hpp; std of one seed alone is empty.
std::string quality_csv(const Grid& grid, const Results& results);

}  // namespace piae::report

#pragma once

#include <string>
#include <vector>

#include "report/accuracy_table.hpp"

namespace piae::report {

/// What a run is worth in which no fault window was known, and so nothing is a gain over another:
/// the most accurate method, rule and ceiling. "Right in most test windows: with generated windows
/// vae by nearest (81.2 %, 1:1) and by a rule envelope-rule (70.1 %)." Empty where there is no row.
std::string most_accurate_without_known(const std::vector<AccuracyRow>& rows);

}  // namespace piae::report

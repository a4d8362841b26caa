#pragma once

#include <string>
#include <vector>

#include "scoring/statistics.hpp"

namespace piae::figures {

/// Returns the ends of the 95 % interval of a mean as two fields, empty if tables show none
/// (report/accuracies.hpp).
std::vector<std::string> shown_interval(const scoring::Summary& summary);

}  // namespace piae::figures

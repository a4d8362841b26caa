#pragma once

#include <string>
#include <vector>

#include "scoring/statistics.hpp"

namespace piae::figures {

/// The ends of the 95 % interval of a mean as two fields. Both are empty for fewer than three
/// seeds: the t interval of two is wider than all that a percentage can be.
std::vector<std::string> shown_interval(const scoring::Summary& summary);

}  // namespace piae::figures

#pragma once

#include <span>

namespace piae::scoring {

/// Returns the area under the receiver operating characteristic: the probability that a positive
/// value is greater than a negative one, where equal ones count half (Hanley and McNeil 1982; the
/// statistic of Mann and Whitney divided by the number of pairs). In [0, 1]; 0.5 if the values
/// carry no information. Throws std::logic_error if either is empty.
double auroc(std::span<const double> negative, std::span<const double> positive);

}  // namespace piae::scoring

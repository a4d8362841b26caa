#pragma once

#include <span>

namespace piae::scoring {

/// The area under the receiver's operating characteristic: the chance that of one value of either
/// kind the positive one is greater, where equal ones count half (Hanley and McNeil 1982; the
/// statistic of Mann and Whitney by the number of pairs). In [0, 1]; 0.5 where values tell nothing.
/// Throws std::logic_error where there is none of a kind.
double auroc(std::span<const double> negative, std::span<const double> positive);

}  // namespace piae::scoring

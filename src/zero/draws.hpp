#pragma once

#include <cstddef>

#include "base/random.hpp"

namespace piae::zero {

/// Between `low` and `high`, which may be the same.
double evenly(Stream& random, double low, double high);

/// Between them, even in the logarithm. Both are positive, or the same.
double log_evenly(Stream& random, double low, double high);

/// True with this probability.
bool bernoulli(Stream& random, double probability);

/// 1 or -1.
double sign(Stream& random);

/// A number of independent events, `mean` on average (Knuth 1969, Section 3.4.1).
std::size_t poisson(Stream& random, double mean);

}  // namespace piae::zero

#pragma once

#include <cstddef>

#include "base/random.hpp"

namespace piae::zero {

/// Between `low` and `high`, which may be the same.
double evenly(Stream& random, double low, double high);

/// Between them, even in the logarithm. Both are positive, or the same.
double log_evenly(Stream& random, double low, double high);

/// Whether what happens with this probability does.
bool happens(Stream& random, double probability);

/// 1 or -1.
double sign(Stream& random);

/// How often something happens that does so `mean` times on average, none of them knowing of the
/// others (Knuth 1969, Section 3.4.1).
std::size_t poisson(Stream& random, double mean);

}  // namespace piae::zero

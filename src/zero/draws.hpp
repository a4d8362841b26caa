#pragma once

#include <cstddef>

#include "base/random.hpp"

namespace piae::zero {

/// Returns a number between `low` and `high`, which may be equal.
double evenly(Stream& random, double low, double high);

/// Returns a log-uniform number between `low` and `high`, which are positive or equal.
double log_evenly(Stream& random, double low, double high);

/// True with this probability.
bool bernoulli(Stream& random, double probability);

/// Returns 1 or -1.
double sign(Stream& random);

/// Returns a Poisson number with this mean (Knuth 1969, Section 3.4.1).
std::size_t poisson(Stream& random, double mean);

}  // namespace piae::zero

#include "zero/draws.hpp"

#include <cmath>

namespace piae::zero {

double evenly(Stream& random, double low, double high) {
  return std::lerp(low, high, random.uniform(0, 1));
}

double log_evenly(Stream& random, double low, double high) {
  const double part = random.uniform(0, 1);
  return low == high ? low : std::exp(std::lerp(std::log(low), std::log(high), part));
}

bool bernoulli(Stream& random, double probability) { return random.uniform(0, 1) < probability; }

double sign(Stream& random) { return random.below(2) == 0 ? 1 : -1; }

std::size_t poisson(Stream& random, double mean) {
  const double least = std::exp(-mean);
  std::size_t count = 0;
  double product = random.uniform(0, 1);
  while (product > least) {
    product *= random.uniform(0, 1);
    ++count;
  }
  return count;
}

}  // namespace piae::zero

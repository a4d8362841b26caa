#include "transfer/edges.hpp"

#include <cmath>
#include <numbers>

namespace piae::transfer {

std::complex<double> Edges::gain(double hz) const {
  const double angle = 2 * std::numbers::pi * hz * lag_s;
  const double seen = exit * std::exp(-std::pow(angle * spread, 2) / 2);
  return 1.0 - std::polar(seen, -angle);
}

}  // namespace piae::transfer

#include "impacts/edges.hpp"

#include <cmath>
#include <numbers>

namespace piae::impacts {

namespace {

double angle_of(const Edges& edges, double hz) { return 2 * std::numbers::pi * hz * edges.lag_s; }

/// Returns exit g(f).
double mean_exit(const Edges& edges, double hz) {
  return edges.exit * std::exp(-std::pow(angle_of(edges, hz) * edges.spread, 2) / 2);
}

}  // namespace

std::complex<double> Edges::gain(double hz) const {
  return 1.0 - std::polar(mean_exit(*this, hz), -angle_of(*this, hz));
}

double Edges::amplitude(double hz) const {
  return std::sqrt(1 + exit * exit - 2 * mean_exit(*this, hz) * std::cos(angle_of(*this, hz)));
}

}  // namespace piae::impacts

#include "twin/derivatives.hpp"

#include <cmath>
#include <numeric>

namespace piae::twin {

namespace {

/// Returns the Kaiser window at `position` from -1 to 1.
double kaiser(double position, double beta) {
  return std::cyl_bessel_i(0.0, beta * std::sqrt(1 - position * position)) /
         std::cyl_bessel_i(0.0, beta);
}

Stencil spectral() {
  constexpr std::int64_t reach = 16;
  constexpr double beta = 8;
  Stencil stencil{.reach = reach};
  for (std::int64_t n = -reach; n <= reach; ++n) {
    const double sign = n % 2 == 0 ? 1 : -1;
    const auto distance = static_cast<double>(n);
    const double window = kaiser(distance / (reach + 1), beta);
    stencil.first.push_back(n == 0 ? 0 : -window * sign / distance);
    stencil.second.push_back(n == 0 ? 0 : -2 * window * sign / (distance * distance));
  }
  // The second derivative of a constant is 0, so the taps must sum to 0.
  stencil.second[reach] = -std::accumulate(stencil.second.begin(), stencil.second.end(), 0.0);
  return stencil;
}

}  // namespace

Stencil stencil_of(Derivatives kind) {
  if (kind == Derivatives::spectral) return spectral();
  return {.reach = 1, .first = {-0.5, 0, 0.5}, .second = {1, -2, 1}};
}

}  // namespace piae::twin

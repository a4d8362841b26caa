#include "inspection/level.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "signal/amplitude.hpp"

namespace piae::inspection {

Level level_of(std::span<const double> signal) {
  const auto n = static_cast<double>(signal.size());
  const double mean = std::accumulate(signal.begin(), signal.end(), 0.0) / n;
  Level level;
  level.rms = signal::rms_of(signal);
  double fourth_powers = 0;
  double greatest = 0;
  for (const double x : signal) {
    const double z = (x - mean) / level.rms;
    fourth_powers += z * z * z * z;
    greatest = std::max(greatest, std::abs(z));
  }
  level.kurtosis = fourth_powers / n;
  level.crest_factor = greatest;
  return level;
}

}  // namespace piae::inspection

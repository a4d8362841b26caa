#include "transfer/ring.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace piae::transfer {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Part of half the sampling rate below which no resonance is looked for.
constexpr double lowest_resonance = 0.03;

/// How many bins from the top, in steps of `step`, the power first is less than half.
double bins_to_half_power(const ArrayXd& answer, Index top, Index step) {
  const double half = answer[top] - std::numbers::ln2 / 2;
  Index i = top;
  while (i + step >= 1 && i + step < answer.size() && answer[i] > half) i += step;
  return std::abs(static_cast<double>(i - top));
}

}  // namespace

ArrayXd ring_answer(const signal::DynamicParameters& ring, double mass_kg, Index bins,
                    double rate_hz) {
  ArrayXd answer(bins);
  const double bin_rad_per_s = std::numbers::pi * rate_hz / static_cast<double>(bins - 1);
  for (Index i = 1; i < bins; ++i) {
    const double w = static_cast<double>(i) * bin_rad_per_s;
    const std::complex<double> resists(ring.stiffness_n_per_m - mass_kg * w * w,
                                       w * ring.damping_ns_per_m);
    answer[i] = std::log(w * w / std::abs(resists));
  }
  answer[0] = answer[1];
  return answer - answer.mean();
}

signal::DynamicParameters strongest_ring(const ArrayXd& answer, double mass_kg, double rate_hz) {
  const auto first = static_cast<Index>(lowest_resonance * static_cast<double>(answer.size()));
  Index top = 0;
  answer.tail(answer.size() - first).maxCoeff(&top);
  top = std::max<Index>(1, top + first);
  const double bin_rad_per_s = std::numbers::pi * rate_hz / static_cast<double>(answer.size() - 1);
  const double width =
      std::max(1.0, bins_to_half_power(answer, top, 1) + bins_to_half_power(answer, top, -1));
  const double w = static_cast<double>(top) * bin_rad_per_s;
  return {mass_kg * w * w, mass_kg * width * bin_rad_per_s};
}

}  // namespace piae::transfer

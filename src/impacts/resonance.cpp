#include "impacts/resonance.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace piae::impacts {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Fraction of half the sampling rate below which no resonance is searched.
constexpr double lowest_resonance = 0.03;

/// Returns the number of bins from the top, in steps of `step`, until the power is below half.
double bins_to_half_power(const ArrayXd& log_response, Index top, Index step) {
  const double half = log_response[top] - std::numbers::ln2 / 2;
  Index i = top;
  while (i + step >= 1 && i + step < log_response.size() && log_response[i] > half) i += step;
  return std::abs(static_cast<double>(i - top));
}

}  // namespace

ArrayXd ring_response(const signal::DynamicParameters& ring, double mass_kg, Index bins,
                      double rate_hz) {
  ArrayXd log_response(bins);
  const double bin_rad_per_s = std::numbers::pi * rate_hz / static_cast<double>(bins - 1);
  for (Index i = 1; i < bins; ++i) {
    const double w = static_cast<double>(i) * bin_rad_per_s;
    const std::complex<double> resists(ring.stiffness_n_per_m - mass_kg * w * w,
                                       w * ring.damping_ns_per_m);
    log_response[i] = std::log(w * w / std::abs(resists));
  }
  log_response[0] = log_response[1];
  return log_response - log_response.mean();
}

signal::DynamicParameters strongest_ring(const ArrayXd& log_response, double mass_kg,
                                         double rate_hz) {
  const auto first =
      static_cast<Index>(lowest_resonance * static_cast<double>(log_response.size()));
  Index top = 0;
  log_response.tail(log_response.size() - first).maxCoeff(&top);
  top = std::max<Index>(1, top + first);
  const double bin_rad_per_s =
      std::numbers::pi * rate_hz / static_cast<double>(log_response.size() - 1);
  const double width = std::max(
      1.0, bins_to_half_power(log_response, top, 1) + bins_to_half_power(log_response, top, -1));
  const double w = static_cast<double>(top) * bin_rad_per_s;
  return {mass_kg * w * w, mass_kg * width * bin_rad_per_s};
}

ArrayXd amplitude(const std::vector<Resonance>& resonances, Index bins, double rate_hz) {
  const double bin_hz = rate_hz / 2 / static_cast<double>(bins - 1);
  ArrayXd amplitudes(bins);
  for (Index i = 0; i < bins; ++i) {
    std::complex<double> sum = 0;
    for (const Resonance& one : resonances) {
      const double u = static_cast<double>(i) * bin_hz / one.natural_hz;
      sum += one.height * 2 * one.damping_ratio * u * u /
             std::complex<double>(1 - u * u, 2 * one.damping_ratio * u);
    }
    amplitudes[i] = std::abs(sum);
  }
  return amplitudes;
}

signal::DynamicParameters ring_of(const std::vector<Resonance>& resonances, double mass_kg) {
  const Resonance& strongest = *std::ranges::max_element(
      resonances, {}, [](const Resonance& one) { return std::abs(one.height); });
  const double rad_per_s = 2 * std::numbers::pi * strongest.natural_hz;
  return {mass_kg * rad_per_s * rad_per_s, 2 * strongest.damping_ratio * mass_kg * rad_per_s};
}

}  // namespace piae::impacts

#include "zero/structure.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "transfer/equaliser.hpp"
#include "zero/background.hpp"
#include "zero/draws.hpp"

namespace piae::zero {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

constexpr std::size_t fewest = 2;
/// What a structure passes on between its resonances / the RMS of their amplitude.
constexpr double between_resonances = 0.05;
/// Of the largest amplitude: a minimum phase needs some at every frequency.
constexpr double least_amplitude = 1e-4;

}  // namespace

std::vector<Resonance> draw_resonances(const Prior& prior, double rate_hz, Stream& random) {
  const auto most = static_cast<std::size_t>(prior.resonances);
  const std::size_t least = std::min(fewest, most);
  std::vector<Resonance> resonances(least + random.below(most - least + 1));
  for (Resonance& one : resonances) {
    one.natural_hz = log_evenly(random, prior.lowest_part, prior.highest_part) * rate_hz / 2;
    one.damping_ratio = log_evenly(random, prior.least_damping, prior.largest_damping);
    one.height = std::exp(random.normal(0, prior.gain_scatter));
    one.height *= sign(random);
  }
  return resonances;
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

ArrayXd draw_log_answer(const std::vector<Resonance>& resonances, const ArrayXd& healthy,
                        double rate_hz, const Prior& prior, Stream& random) {
  const ArrayXd rings = amplitude(resonances, healthy.size(), rate_hz);
  const double power = random.uniform(0, 1) * prior.healthy_structure;
  const std::vector<double> gains =
      transfer::draw_gains(random, static_cast<std::size_t>(healthy.size()),
                           {.spread_db = prior.path_db, .knots = path_knots});
  const ArrayXd heard = (rings / std::sqrt(rings.square().mean()) + between_resonances) *
                        (power * healthy).exp() *
                        Eigen::Map<const ArrayXd>(gains.data(), healthy.size());
  return (heard + least_amplitude * heard.maxCoeff()).log();
}

}  // namespace piae::zero

#include "zero/structure.hpp"

#include <algorithm>
#include <cmath>

#include "impacts/path.hpp"
#include "zero/background.hpp"
#include "zero/draws.hpp"

namespace piae::zero {

namespace {

using Eigen::ArrayXd;

constexpr std::size_t fewest = 2;
/// Gain of a structure between its resonances / the RMS of their amplitude.
constexpr double between_resonances = 0.05;
/// Fraction of the largest amplitude; a minimum phase needs a positive amplitude at every
/// frequency.
constexpr double least_amplitude = 1e-4;

}  // namespace

std::vector<impacts::Resonance> draw_resonances(const Prior& prior, double rate_hz,
                                                Stream& random) {
  const auto most = static_cast<std::size_t>(prior.resonances);
  const std::size_t least = std::min(fewest, most);
  std::vector<impacts::Resonance> resonances(least + random.below(most - least + 1));
  for (impacts::Resonance& one : resonances) {
    one.natural_hz = log_evenly(random, prior.lowest_part, prior.highest_part) * rate_hz / 2;
    one.damping_ratio = log_evenly(random, prior.least_damping, prior.largest_damping);
    one.height = std::exp(random.normal(0, prior.gain_scatter));
    one.height *= sign(random);
  }
  return resonances;
}

ArrayXd draw_log_response(const std::vector<impacts::Resonance>& resonances, const ArrayXd& healthy,
                          double rate_hz, const Prior& prior, Stream& random) {
  const ArrayXd rings = impacts::amplitude(resonances, healthy.size(), rate_hz);
  const double power = random.uniform(0, 1) * prior.healthy_structure;
  const ArrayXd gains = impacts::draw_gains(random, healthy.size(),
                                            {.spread_db = prior.path_db, .knots = path_knots});
  const ArrayXd amplitudes = (rings / std::sqrt(rings.square().mean()) + between_resonances) *
                             (power * healthy).exp() * gains;
  return (amplitudes + least_amplitude * amplitudes.maxCoeff()).log();
}

}  // namespace piae::zero

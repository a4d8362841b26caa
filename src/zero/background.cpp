#include "zero/background.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "bearing/kinematics.hpp"
#include "impacts/path.hpp"
#include "zero/draws.hpp"

namespace piae::zero {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

ArrayXd about_its_mean(std::span<const float> window) {
  const ArrayXd samples =
      Eigen::Map<const Eigen::ArrayXf>(window.data(), static_cast<Index>(window.size()))
          .cast<double>();
  return samples - samples.mean();
}

double rms(const ArrayXd& window) { return std::sqrt(window.square().mean()); }

constexpr double present = 0.7;
constexpr double least_depth = 0.1;  // fraction of the largest depth
constexpr int harmonics = 3;
constexpr double more_impacts = 2;
constexpr double impact_scatter = 0.7;  // standard deviation of a strength's logarithm

/// Adds amplitude cos(2 pi hz t + phase), by rotating a phasor from sample to sample.
void add_cosine(double amplitude, double hz, double rate_hz, double phase, ArrayXd& sum) {
  const std::complex<double> turn = std::polar(1.0, 2 * std::numbers::pi * hz / rate_hz);
  std::complex<double> now = std::polar(amplitude, phase);
  for (double& sample : sum) {
    sample += now.real();
    now *= turn;
  }
}

void add_rate(double hz, double rate_hz, double depth, Stream& random, ArrayXd& sum) {
  for (int h = 1; h <= harmonics; ++h) {
    const double amplitude = depth * std::pow(random.uniform(0, 1), h - 1) / h;
    add_cosine(amplitude, h * hz, rate_hz, random.uniform(0, 2 * std::numbers::pi), sum);
  }
}

}  // namespace

ArrayXd draw_background(std::span<const float> healthy, double spread_db, Stream& random) {
  ArrayXd window = about_its_mean(healthy);
  window /= rms(window);
  if (bernoulli(random, 0.5)) window.reverseInPlace();
  if (spread_db > 0) {
    const auto bins = static_cast<Index>(healthy.size() / 2 + 1);
    impacts::equalise(
        {window.data(), healthy.size()},
        impacts::draw_gains(random, bins, {.spread_db = spread_db, .knots = path_knots}));
  }
  return window;
}

std::vector<float> at_level_of(std::span<const float> healthy, const ArrayXd& window) {
  const ArrayXd deviation = window - window.mean();
  const double level = rms(deviation);
  const Eigen::ArrayXf made =
      (level > 0 ? ArrayXd(deviation * (rms(about_its_mean(healthy)) / level)) : deviation)
          .cast<float>();
  return {made.begin(), made.end()};
}

ArrayXd draw_modulation(const Scene& scene, const bearing::Geometry& geometry, std::size_t samples,
                        double rate_hz, const Prior& prior, Stream& random) {
  const bearing::FaultFrequencies rates =
      bearing::fault_frequencies(geometry, scene.shaft_speed_rpm);
  ArrayXd sum = ArrayXd::Ones(static_cast<Eigen::Index>(samples));
  for (const double hz : {rates.bpfo_hz, rates.bpfi_hz, rates.shaft_hz, 2 * rates.bsf_hz}) {
    if (!bernoulli(random, present)) continue;
    const double depth = log_evenly(random, least_depth * prior.modulation, prior.modulation);
    const double slip = hz == rates.shaft_hz ? 0 : evenly(random, -prior.slip, prior.slip);
    add_rate(hz * (1 + slip), rate_hz, depth, random, sum);
  }
  return sum.max(0.0);
}

std::vector<impacts::Impact> draw_stray_impacts(double frame_s, const Prior& prior,
                                                Stream& random) {
  if (!bernoulli(random, prior.stray_impacts)) return {};
  std::vector<impacts::Impact> stray(1 + poisson(random, more_impacts));
  for (impacts::Impact& impact : stray) {
    impact.time_s = random.uniform(0, frame_s);
    impact.strength = std::exp(random.normal(0, impact_scatter));
    impact.strength *= sign(random);
  }
  return stray;
}

}  // namespace piae::zero

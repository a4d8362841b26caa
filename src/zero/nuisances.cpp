#include "zero/nuisances.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "bearing/kinematics.hpp"
#include "zero/draws.hpp"

namespace piae::zero {

namespace {

using Eigen::ArrayXd;

constexpr double present = 0.7;
constexpr double least_depth = 0.1;  // / the largest
constexpr int harmonics = 3;
constexpr double more_knocks = 2;
constexpr double knock_scatter = 0.7;  // standard deviation of the logarithm

/// Adds amplitude cos(2 pi hz t + phase). From sample to sample the phase turns by one angle.
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

ArrayXd draw_modulation(const Scene& scene, const bearing::Geometry& geometry, std::size_t samples,
                        double rate_hz, const Prior& prior, Stream& random) {
  const bearing::FaultFrequencies rates =
      bearing::fault_frequencies(geometry, scene.shaft_speed_rpm);
  ArrayXd sum = ArrayXd::Ones(static_cast<Eigen::Index>(samples));
  for (const double hz : {rates.bpfo_hz, rates.bpfi_hz, rates.shaft_hz, 2 * rates.bsf_hz}) {
    if (!happens(random, present)) continue;
    const double depth = log_evenly(random, least_depth * prior.modulation, prior.modulation);
    const double slip = hz == rates.shaft_hz ? 0 : evenly(random, -prior.slip, prior.slip);
    add_rate(hz * (1 + slip), rate_hz, depth, random, sum);
  }
  return sum.max(0.0);
}

std::vector<transfer::Strike> draw_stray_knocks(double frame_s, const Prior& prior,
                                                Stream& random) {
  if (!happens(random, prior.stray_knocks)) return {};
  std::vector<transfer::Strike> knocks(1 + poisson(random, more_knocks));
  for (transfer::Strike& knock : knocks) {
    knock.time_s = random.uniform(0, frame_s);
    knock.strength = std::exp(random.normal(0, knock_scatter));
    knock.strength *= sign(random);
  }
  return knocks;
}

}  // namespace piae::zero

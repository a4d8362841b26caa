#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/random.hpp"
#include "signal/recordings.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

/// One resonance of the structure between a defect and the sensor.
struct Resonance {
  double natural_hz = 0;
  double damping_ratio = 0;
  double height = 0;  ///< of its peak, with a sign
};

/// From two to the prior's number of them. Natural frequencies and damping ratios are log-uniform,
/// heights log-normal, signs even.
std::vector<Resonance> draw_resonances(const Prior& prior, double rate_hz, Stream& random);

/// The amplitude of their sum at `bins` frequencies from 0 Hz to half the sampling rate, each as
/// eq. 13 without its contacts answers one blow with an acceleration (transfer/ring.hpp):
///   sum of height 2 zeta w^2 / (w_n^2 - w^2 + 2 i zeta w_n w).
Eigen::ArrayXd amplitude(const std::vector<Resonance>& resonances, Eigen::Index bins,
                         double rate_hz);

/// The k and c of the resonance with the highest peak: w_n^2 = k / M, 2 zeta w_n = c / M.
signal::DynamicParameters ring_of(const std::vector<Resonance>& resonances, double mass_kg);

/// The logarithm of the amplitude with which a blow is heard at the sensor: resonances, times a
/// power of the healthy spectrum that is uniform up to the prior's (where the machine itself
/// sounds, it passes vibration on), times a random smooth path. `healthy` is a logarithm at the
/// same bins.
Eigen::ArrayXd draw_log_answer(const std::vector<Resonance>& resonances,
                               const Eigen::ArrayXd& healthy, double rate_hz, const Prior& prior,
                               Stream& random);

}  // namespace piae::zero

#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/random.hpp"
#include "impacts/resonance.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

/// Returns from two to the prior's number of resonances. Natural frequencies and damping ratios are
/// log-uniform, heights log-normal, signs random.
std::vector<impacts::Resonance> draw_resonances(const Prior& prior, double rate_hz, Stream& random);

/// Returns the logarithm of the amplitude of the response at the sensor: resonances, times a power
/// of the healthy spectrum, times a random smooth path. The power is uniform up to the prior's:
/// frequencies at which the machine vibrates are frequencies that it transmits. `healthy` is a
/// logarithm at the same bins.
Eigen::ArrayXd draw_log_response(const std::vector<impacts::Resonance>& resonances,
                                 const Eigen::ArrayXd& healthy, double rate_hz, const Prior& prior,
                                 Stream& random);

}  // namespace piae::zero

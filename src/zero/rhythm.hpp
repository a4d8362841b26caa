#pragma once

#include <vector>

#include "base/random.hpp"
#include "transfer/excitation.hpp"
#include "zero/machine.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

/// When a defect is struck.
struct Rhythm {
  double period_s = 0;
  double slip = 0;    ///< of the rate of strikes, and of the cage: deviation / rate
  double jitter = 0;  ///< of the time to the next strike: standard deviation / period
};

/// The rate is the kinematic one (eqs 5 to 7) by 1 + slip, and slip is uniform within the prior's
/// (Randall and Antoni 2011: 1 to 2 %). The jitter is log-uniform from a seventh of the prior's on.
Rhythm draw_rhythm(const Scene& scene, const Prior& prior, Stream& random);

/// Strikes of strength 1, one after another as transfer/strike_train.hpp has them follow.
std::vector<transfer::Strike> regular_strikes(const Rhythm& rhythm, double frame_s, Stream& random);

}  // namespace piae::zero

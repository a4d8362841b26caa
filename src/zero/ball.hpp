#pragma once

#include <vector>

#include "base/random.hpp"
#include "impacts/times.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

// A ball's axis of rotation is not fixed, so its defect meets the races less regularly than balls
// meet a defect of a race. Smith and Randall 2015 show records of faulty balls with lines of their
// cage, and records without any line.

/// A ball's defect meets both races alternately. Multiplies every second impact by a factor that is
/// uniform from the prior's to 1.
void alternate_races(const Prior& prior, Stream& random, std::vector<impacts::Impact>& impacts);

/// Outside the load zone a ball floats and turns freely. In each turn of the cage (cage_hz), the
/// impacts get a new phase, up to half a period away, with a probability that is uniform up to the
/// prior's.
void turn_between_passes(double period_s, double cage_hz, const Prior& prior, Stream& random,
                         std::vector<impacts::Impact>& impacts);

/// Moves a fraction of impacts to random moments of the frame, because a freely turned ball may
/// meet a race at any time. The fraction is uniform up to the prior's.
void scatter_in_time(double frame_s, const Prior& prior, Stream& random,
                     std::vector<impacts::Impact>& impacts);

/// The axis wanders, so the defect meets the track for only a fraction of the time, uniform from
/// the prior's to 1. Multiplies an impact off the track by `off_track`. A normal process w(t) with
/// the correlation exp(-t / T) is compared with a threshold; T is log-uniform from 0.5 to 20 turns
/// of the cage.
void leave_track(double period_s, double cage_hz, double frame_s, const Prior& prior,
                 Stream& random, std::vector<impacts::Impact>& impacts);

inline constexpr double off_track = 0.03;

}  // namespace piae::zero

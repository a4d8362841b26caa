#pragma once

#include <vector>

#include "base/random.hpp"
#include "impacts/times.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

// A ball turns about an axis that nothing holds, so its defect meets the races less orderly than
// one of a race meets balls (Smith and Randall 2015 show records of balls with lines of their cage,
// and ones without any line).

/// A defect meets both races in turn: every second impact is weaker, by a part that is uniform from
/// the prior's to 1.
void alternate_races(const Prior& prior, Stream& random, std::vector<impacts::Impact>& impacts);

/// Outside the load zone a ball floats and turns freely: with a probability that is uniform up to
/// the prior's, a turn of the cage (cage_hz) finds it at a new phase, up to half a period away.
void turn_between_passes(double period_s, double cage_hz, const Prior& prior, Stream& random,
                         std::vector<impacts::Impact>& impacts);

/// A share of impacts that is uniform up to the prior's is at any moment of the frame: the spot
/// meets a race where the ball has just turned it.
void scatter_in_time(double frame_s, const Prior& prior, Stream& random,
                     std::vector<impacts::Impact>& impacts);

/// The axis wanders, so the spot meets the track for a share of the time alone, uniform from the
/// prior's to 1. Off the track an impact is times `off_track`. A normal process w(t) with a
/// correlation of exp(-t / T) decides against a threshold, and T is log-uniform from half a turn of
/// the cage to 20.
void leave_track(double period_s, double cage_hz, double frame_s, const Prior& prior,
                 Stream& random, std::vector<impacts::Impact>& impacts);

inline constexpr double off_track = 0.03;

}  // namespace piae::zero

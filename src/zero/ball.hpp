#pragma once

#include <vector>

#include "base/random.hpp"
#include "transfer/excitation.hpp"
#include "zero/prior.hpp"
#include "zero/rhythm.hpp"

namespace piae::zero {

// A ball turns about an axis that nothing holds, so its defect meets the races less orderly than
// one of a race meets balls (Smith and Randall 2015 show records of balls with lines of their cage,
// and ones without any line).

/// A defect meets both races in turn. On one of them it is heard less: every second strike is times
/// a part that is uniform from the prior's to 1.
void alternate_races(const Prior& prior, Stream& random, std::vector<transfer::Strike>& strikes);

/// Outside the load zone a ball floats and turns freely: with a probability that is uniform up to
/// the prior's, a turn of the cage (cage_hz) finds it at a new phase, up to half a period from the
/// rhythm.
void turn_between_passes(const Rhythm& rhythm, double cage_hz, const Prior& prior, Stream& random,
                         std::vector<transfer::Strike>& strikes);

/// A share of strikes that is uniform up to the prior's is at any moment of the frame: the spot
/// meets a race where the ball has just turned it.
void scatter_in_time(double frame_s, const Prior& prior, Stream& random,
                     std::vector<transfer::Strike>& strikes);

/// The axis wanders, so the spot meets the track for a share of the time alone, uniform from the
/// prior's to 1; beside it a strike is times `off_track`. Whether it does is a normal process
/// w(t) with a correlation of exp(-t / T) against a threshold, and T is log-uniform from half a
/// turn of the cage to 20.
void leave_track(const Rhythm& rhythm, double cage_hz, double frame_s, const Prior& prior,
                 Stream& random, std::vector<transfer::Strike>& strikes);

inline constexpr double off_track = 0.03;

}  // namespace piae::zero

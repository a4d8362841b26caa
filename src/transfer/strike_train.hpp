#pragma once

#include <span>
#include <vector>

#include "base/random.hpp"
#include "transfer/excitation.hpp"

namespace piae::transfer {

/// How a defect is struck in the tested condition.
struct Rhythm {
  double period_s = 0;
  double jitter = 0;  ///< of the time to the next strike: standard deviation / period
  Edges edges;
};

/// Strikes from a random start in the first period to the end of a frame. Their strengths follow
/// each other as in a known window, from a random one on: so the load zone, which inner race and
/// balls pass with so many strikes a turn, stays where it was. The lag of each differs from the
/// others' by the spread of the edges. There must be a strength.
std::vector<Strike> draw_strikes(Stream& random, const Rhythm& rhythm,
                                 std::span<const double> strengths, double frame_s);

}  // namespace piae::transfer

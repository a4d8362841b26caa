#pragma once

#include <functional>
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

/// How many strikes a frame has at most.
std::size_t most_strikes(const Rhythm& rhythm, double frame_s);

/// Calls `strike` with the time of each strike, from a random moment of the first period to the end
/// of a frame. Each follows the last one by a period with the jitter, so deviations add up, as
/// balls that slip do not come back to their places. What `strike` draws comes before the next
/// period.
void for_each_strike(Stream& random, double period_s, double jitter, double frame_s,
                     const std::function<void(double time_s)>& strike);

/// Strikes from a random start in the first period to the end of a frame, with these strengths
/// (strengths.hpp) in their order: most_strikes() of them. The lag of each differs from the others'
/// by the spread of the edges.
std::vector<Strike> draw_strikes(Stream& random, const Rhythm& rhythm,
                                 std::span<const double> strengths, double frame_s);

/// The times in s of those strikes that lie within a window of `length` samples. All are below the
/// time at which it ends, of which the last sample may be a rounding error away.
std::vector<double> times_within(std::span<const double> strikes, std::size_t length,
                                 double rate_hz);

}  // namespace piae::transfer

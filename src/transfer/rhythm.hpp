#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "transfer/comb.hpp"

namespace piae::transfer {

using Cut = std::vector<double>;

/// A window, and where in it the structure is struck, in samples, ascending.
struct StruckWindow {
  std::vector<double> samples;
  std::vector<double> strikes;
};

/// A window cut at its strikes: what follows each, from a little before it (where the comb stands
/// the blow has begun) to a little before the next. Only those that the window holds whole.
std::vector<Cut> cut_responses(std::span<const double> window, const Comb& comb);

/// A window in which the structure answers as in these responses, but is struck every `period`
/// samples. They follow each other in their order, from a random one on: so the load zone, which
/// inner race and balls pass with so many strikes a turn, stays where it was. Each strike comes
/// later or earlier by a normal deviation of `jitter` periods. Where the new period is shorter,
/// responses overlap and fade; where it is longer, they go on with the ends of others, which are
/// the machine's background and what still rings. There must be a response, and a period of two
/// samples or more.
StruckWindow struck(const std::vector<Cut>& responses, double period, double jitter,
                    std::size_t length, Stream& random);

}  // namespace piae::transfer

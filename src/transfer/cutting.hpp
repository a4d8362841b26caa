#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "impacts/times.hpp"
#include "transfer/comb.hpp"

namespace piae::transfer {

using Cut = std::vector<double>;

/// A window, and the places of its impacts in samples, ascending.
struct StruckWindow {
  std::vector<double> samples;
  std::vector<double> strikes;
};

/// A window cut at its impacts: what follows each, from a little before it (where the comb stands
/// the impact has already happened) to a little before the next. Only those that the window holds
/// whole.
std::vector<Cut> cut_responses(std::span<const double> window, const Comb& comb);

/// A window of these responses with impacts at this rate, in samples. Responses keep their order,
/// from a random one on: so the load zone, which inner race and balls pass with the same number of
/// impacts a turn, stays where it was. If the new period is shorter, responses overlap and fade; if
/// it is longer, they continue with the ends of others, which are the machine's background and what
/// still rings. There must be a response, and a period of two samples or more.
StruckWindow struck(const std::vector<Cut>& responses, const impacts::ImpactRate& rate,
                    std::size_t length, Stream& random);

}  // namespace piae::transfer

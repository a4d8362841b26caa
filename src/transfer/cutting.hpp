#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "impacts/times.hpp"
#include "transfer/comb.hpp"

namespace piae::transfer {

using Cut = std::vector<double>;

/// A window, and the positions of its impacts in samples, ascending.
struct ImpactWindow {
  std::vector<double> samples;
  std::vector<double> impact_positions;
};

/// Cuts a window at its impacts. Each cut reaches from a little before an impact (the comb lies
/// behind it) to a little before the next. Returns only the cuts that lie wholly in the window.
std::vector<Cut> cut_responses(std::span<const double> window, const Comb& comb);

/// Returns a window of these responses with impacts at this rate, in samples. Responses keep their
/// order, from a random one on. So the load zone keeps its place, because an inner race or a ball
/// passes it with the same number of impacts per turn. If the new period is shorter, responses
/// overlap and fade. If the new period is longer, responses continue with the ends of others: the
/// machine's background and decaying rings. Needs at least one response and a period of two samples
/// or more.
ImpactWindow with_impacts(const std::vector<Cut>& responses, const impacts::ImpactRate& rate,
                          std::size_t length, Stream& random);

}  // namespace piae::transfer

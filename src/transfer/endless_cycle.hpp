#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "signal/cycle.hpp"
#include "transfer/comb.hpp"
#include "transfer/cutting.hpp"

namespace piae::transfer {

/// A window as an endless cycle.
struct EndlessCycle {
  std::vector<double> samples;  ///< starting at an impact
  signal::Cycle cycle;
  bool has_whole_period = true;  ///< false if not one whole period fits into the window
};

/// Makes a cycle of as many whole periods between impacts as fit, from the stretch of the window
/// with the most power. If not one fits, the whole window is the cycle, which has a seam.
EndlessCycle endless_cycle_of(std::span<const double> window, const Comb& comb);

/// Returns a window of `length` samples that starts at a random place of the first cycle. At a
/// random moment it continues in the second, at the same phase of the period between impacts, to
/// half a sample (signal/passage.hpp). The impacts are empty if either cycle has no impact rate.
ImpactWindow window_of_cycles(const EndlessCycle& first, const EndlessCycle& second,
                              std::size_t length, Stream& random);

}  // namespace piae::transfer

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace piae::transfer {

/// Impact times in samples of a window: first + i period.
struct Comb {
  double first = 0;   ///< at least 0, below the period
  double period = 0;  ///< samples from impact to impact

  /// Returns the impacts within `length` samples, rounded to samples.
  [[nodiscard]] std::vector<std::size_t> impact_positions(std::size_t length) const;
};

/// Returns the comb on which the envelope of a window is highest, among combs whose period is
/// within 1.5 % of the kinematic period. This allows for the slip of balls and for shaft speeds
/// that differ from nominal. The envelope is that of the whole band (Hilbert), averaged over a
/// fourteenth of the period. So the comb lies in the middle of the first ringing, a few samples
/// after the impact. The period must be at least two samples.
Comb find_comb(std::span<const double> window, double nominal_period);

/// Returns the strength of each impact of a window, as a multiple of their mean: the envelope's
/// height above its median, at least 0. All are 1 if nothing stands out.
std::vector<double> seen_strengths(std::span<const double> window, const Comb& comb);

}  // namespace piae::transfer

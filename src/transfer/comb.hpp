#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace piae::transfer {

/// When a defect is struck, in samples of a window: at first + i period.
struct Comb {
  double first = 0;   ///< from 0 to below the period
  double period = 0;  ///< samples from strike to strike

  /// The strikes within `length` samples, rounded to samples.
  [[nodiscard]] std::vector<std::size_t> strikes(std::size_t length) const;
};

/// The comb on which the envelope of a window is highest, of all whose period is within 1.5 % of
/// the one that kinematics says: so much do balls slip, and shafts differ from their nominal speed.
/// The envelope is that of the whole band (Hilbert), averaged over a fourteenth of the period, so
/// that a comb stands on the middle of the first ringing, a few samples after the blow. The period
/// must be at least two samples.
Comb find_comb(std::span<const double> window, double nominal_period);

/// How strong each strike of a window is, as a multiple of their mean: how far that envelope stands
/// above its median, at least 0. Equal, where nothing stands out.
std::vector<double> seen_strengths(std::span<const double> window, const Comb& comb);

}  // namespace piae::transfer

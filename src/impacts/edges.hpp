#pragma once

#include <complex>

namespace piae::impacts {

/// Effect of both edges of a defect on the spectrum. A ball that rolls over a spall is unloaded at
/// one edge and hits the other: the step of eq. 9's rectangle has opposite signs at the two edges.
/// So each pass causes two impacts of opposite sign, `lag_s` apart; the second is `exit` times the
/// first. The lag of each pass is normal with a standard deviation of `spread` times the mean lag.
/// One pass multiplies the spectrum of the structure, which is fixed in Hz, by 1 - exit exp(-2 pi i
/// f lag). The minima at whole multiples of 1 / lag move with the shaft speed.
struct Edges {
  double lag_s = 0;
  double exit = 0;  ///< from 0 to 1
  double spread = 0;

  /// Returns the mean over passes:
  ///   E(f) = 1 - exit g(f) exp(-2 pi i f lag), with g(f) = exp(-2 (pi f lag spread)^2).
  [[nodiscard]] std::complex<double> gain(double hz) const;
  /// Returns the amplitude that a mean power spectrum shows, the root of
  ///   1 + exit^2 - 2 exit g(f) cos(2 pi f lag).
  [[nodiscard]] double amplitude(double hz) const;
};

}  // namespace piae::impacts

#pragma once

#include <complex>

namespace piae::impacts {

/// What both edges of a defect do to the response of the structure. A ball that rolls over a spall
/// is unloaded at one edge and strikes the other; the step of eq. 9's rectangle has opposite signs
/// at both. So the machine is struck twice, `lag_s` apart and with opposite signs, and the second
/// blow is `exit` times the first. Each strike has a lag of its own, normal with a standard
/// deviation of `spread` times the lag. One strike multiplies the spectrum of the structure, which
/// stays where it is in Hz, by 1 - exit exp(-2 pi i f lag); the minima at the whole multiples of
/// 1 / lag move with the speed of the shaft.
struct Edges {
  double lag_s = 0;
  double exit = 0;  ///< from 0 to 1
  double spread = 0;

  /// The mean over strikes:
  ///   E(f) = 1 - exit g(f) exp(-2 pi i f lag), with g(f) = exp(-2 (pi f lag spread)^2).
  [[nodiscard]] std::complex<double> gain(double hz) const;
  /// What a mean power spectrum shows of it, as an amplitude: the root of
  ///   1 + exit^2 - 2 exit g(f) cos(2 pi f lag).
  [[nodiscard]] double amplitude(double hz) const;
};

}  // namespace piae::impacts

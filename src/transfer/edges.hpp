#pragma once

#include <complex>

namespace piae::transfer {

/// What both edges of a defect do to the response of the structure. A ball that rolls over a spall
/// is unloaded at one edge and strikes the other; the step of eq. 9's rectangle has opposite signs
/// at both. So the machine is struck twice, `lag_s` apart and with opposite signs, and the second
/// blow is `exit` times the first. Each strike has a lag of its own, normal with a standard
/// deviation of `spread` times the lag. The spectrum of a fault window is that of the structure,
/// which stays where it is in Hz, times
///   E(f) = 1 - exit exp(-2 (pi f lag spread)^2) exp(-2 pi i f lag),
/// with its minima at the whole multiples of 1 / lag, which move with the speed of the shaft.
struct Edges {
  double lag_s = 0;
  double exit = 0;  ///< from 0 to 1
  double spread = 0;

  /// E(f).
  [[nodiscard]] std::complex<double> gain(double hz) const;
};

}  // namespace piae::transfer

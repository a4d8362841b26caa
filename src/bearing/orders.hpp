#pragma once

#include <optional>

#include "bearing/geometry.hpp"

namespace piae::bearing {

/// Fault frequencies of a bearing as multiples of the shaft frequency, as makers print them.
struct Orders {
  double bpfo = 0;
  double bpfi = 0;
  std::optional<double> bsf = {};  ///< spin of a ball; some makers print twice this value
  std::optional<double> ftf = {};  ///< rate of the cage
};

/// Pitch diameter assumed for a bearing that is given by its orders.
inline constexpr double nominal_pitch_mm = 40;

/// Returns the bearing that has these orders, from equations 5 to 7: BPFO + BPFI is the number of
/// balls, (BPFI - BPFO) / balls is gamma = d cos(alpha) / D, and BSF gives d / D = (1 - gamma^2) /
/// (2 BSF). Without BSF the contact angle is 0. Orders do not determine the size of the bearing, so
/// its pitch diameter is nominal_pitch_mm. Throws Error(bad_input) if no bearing has these orders
/// within 1 %: if BPFO + BPFI is not whole, FTF is not BPFO / balls, or the balls that BSF implies
/// do not fit. The message points out a BSF that seems to be doubled.
Geometry geometry_of(const Orders& orders);

}  // namespace piae::bearing

#pragma once

#include <optional>

#include "bearing/geometry.hpp"

namespace piae::bearing {

/// The frequencies of a bearing's faults as multiples of the shaft's, as makers print them.
struct Orders {
  double bpfo = 0;
  double bpfi = 0;
  std::optional<double> bsf = {};  ///< spin of a ball; some makers print its double
  std::optional<double> ftf = {};  ///< the cage's
};

/// The pitch diameter that stands for the unknown one of a bearing given by its orders.
inline constexpr double nominal_pitch_mm = 40;

/// Gives the bearing that has these orders, by equations 5 to 7 solved for it: BPFO + BPFI is the
/// number of balls, (BPFI - BPFO) / balls is gamma = d cos(alpha) / D, and BSF gives d / D =
/// (1 - gamma^2) / (2 BSF). Without BSF the contact angle is taken as 0. Orders do not say how
/// large the bearing is: its pitch diameter is nominal_pitch_mm. Throws Error(bad_input) where no
/// bearing has them: by more than 1 %, BPFO + BPFI is not whole, FTF is not BPFO / balls, or BSF
/// belongs to balls that would not fit; the line says where BSF seems to be its double.
Geometry geometry_of(const Orders& orders);

}  // namespace piae::bearing

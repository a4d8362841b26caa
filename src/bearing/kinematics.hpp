#pragma once

#include "bearing/geometry.hpp"

namespace piae::bearing {

/// Angular speeds in rad/s, outer ring fixed.
struct Speeds {
  double shaft = 0;  ///< omega_s, of the inner ring
  double cage = 0;   ///< omega_c, eq. 5: all balls run round with it
  double spin = 0;   ///< of a ball about its own axis, eq. 7
};

/// Lines that a local defect leaves in an envelope spectrum, in Hz.
struct FaultFrequencies {
  double shaft_hz = 0;
  double cage_hz = 0;  ///< FTF
  double bpfo_hz = 0;  ///< balls over a point of the outer race
  double bpfi_hz = 0;  ///< balls over a point of the inner race
  double bsf_hz = 0;   ///< spin of a ball; its defect strikes a race at twice this
};

/// Throws Error(bad_input) for a bearing that cannot be: fewer than 3 balls, sizes that are not
/// positive, balls that overlap on the pitch circle, races on the wrong side of it, a contact angle
/// outside [0, 90) degrees.
void validate(const Geometry& geometry);

/// Eqs 5 and 7. `slip` is the relative loss of cage speed against pure rolling. The balls' spin
/// loses as much, which holds where they slide on the inner race and still roll on the outer one.
Speeds speeds(const Geometry& geometry, double shaft_speed_rpm, double slip = 0);

FaultFrequencies fault_frequencies(const Geometry& geometry, double shaft_speed_rpm,
                                   double slip = 0);

}  // namespace piae::bearing

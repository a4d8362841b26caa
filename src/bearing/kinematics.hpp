#pragma once

#include "bearing/geometry.hpp"

namespace piae::bearing {

/// The angular speeds in rad/s of a bearing whose outer ring is fixed.
struct Speeds {
  double shaft = 0;  ///< omega_s, of the inner ring
  double cage = 0;   ///< omega_c, eq. 5; all balls orbit with the cage
  double spin = 0;   ///< spin of a ball about its own axis, eq. 7
};

/// The frequencies, in Hz, at which a local defect leaves lines in an envelope spectrum.
struct FaultFrequencies {
  double shaft_hz = 0;
  double cage_hz = 0;  ///< FTF
  double bpfo_hz = 0;  ///< rate at which balls pass a point of the outer race
  double bpfi_hz = 0;  ///< rate at which balls pass a point of the inner race
  double bsf_hz = 0;   ///< spin of a ball; a defect on it hits the races twice per turn
};

/// Throws Error(bad_input) for an impossible bearing: fewer than 3 balls, sizes that are not
/// positive, balls that overlap on the pitch circle, races on the wrong side of it, a contact angle
/// outside [0, 90) degrees.
void validate(const Geometry& geometry);

/// Eqs 5 and 7. `slip` is the fraction of the cage's speed that is lost compared with pure rolling.
/// The balls' spin loses the same fraction: they slide on the inner race and roll on the outer
/// race.
Speeds speeds(const Geometry& geometry, double shaft_speed_rpm, double slip = 0);

/// Returns the fault frequencies at this speed and slip.
FaultFrequencies fault_frequencies(const Geometry& geometry, double shaft_speed_rpm,
                                   double slip = 0);

}  // namespace piae::bearing

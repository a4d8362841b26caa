#pragma once

namespace piae::bearing {

/// How a bearing runs. Angles count from the load direction, the middle of the load zone, in the
/// sense of rotation, and hold at time 0.
struct Motion {
  double shaft_speed_rpm = 0;
  double slip = 0;            ///< relative loss of cage and spin speed, see speeds()
  double cage_angle_rad = 0;  ///< theta_1 of eq. 6; ball j follows 2 pi (j - 1) / n_b ahead
  /// Outer: theta_D of eq. 9, which stays (0: where the load presses, CWRU's "6 o'clock").
  /// Inner: theta_i, which turns with the shaft. Roller: phi of eq. 7, which turns with the spin.
  double defect_angle_rad = 0;
};

}  // namespace piae::bearing

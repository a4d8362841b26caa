#pragma once

namespace piae::bearing {

/// Motion of a bearing. Angles hold at time 0. They count in the direction of rotation from the
/// load direction, which is the middle of the load zone.
struct Motion {
  double shaft_speed_rpm = 0;
  double slip = 0;            ///< fraction of cage and spin speed that is lost, see speeds()
  double cage_angle_rad = 0;  ///< theta_1 of eq. 6; ball j is 2 pi (j - 1) / n_b ahead of ball 1
  /// Angle of the defect. Outer race: theta_D of eq. 9, which is constant (0 is the load direction,
  /// "6 o'clock" of CWRU). Inner race: theta_i, which turns with the shaft. Ball: phi of eq. 7,
  /// which turns with the ball's spin.
  double defect_angle_rad = 0;

  bool operator==(const Motion&) const = default;
};

}  // namespace piae::bearing

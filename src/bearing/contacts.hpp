#pragma once

#include <vector>

#include "bearing/defect.hpp"
#include "bearing/geometry.hpp"
#include "bearing/kinematics.hpp"

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

/// A ball on the loaded side. The inner ring's displacement s presses it by s * along - delta.
struct BallContact {
  double along = 0;    ///< cos(psi_j) of its angle from the load direction; positive
  double delta_m = 0;  ///< eq. 11: clearance, and the defect's depth while it is in the defect
};

/// Which balls can carry load at a given time, from eqs 5 to 11. Outside the load zone
/// (cos(psi_j) <= 0) a ball cannot. Of a bearing with a roller defect one ball, the first, has it.
class BallPassage {
 public:
  /// Throws Error(bad_input) for a geometry, defect or motion that cannot be.
  BallPassage(const Geometry& geometry, const LocalDefect& defect, const Motion& motion,
              double clearance_m);

  /// Replaces the contents of `contacts`.
  void at(double time_s, std::vector<BallContact>& contacts) const;

 private:
  struct Direction {
    double cosine;
    double sine;
  };

  /// Index of the one ball that is in the defect, -1 for none.
  [[nodiscard]] int ball_in_defect(double time_s, double cage_angle_rad) const;

  Motion motion_;
  Speeds speeds_;
  Defect kind_;
  double half_angle_rad_;
  double clearance_m_;
  double clearance_in_defect_m_;
  double ball_distance_rad_;
  std::vector<Direction> balls_;  // seen from the first ball
};

}  // namespace piae::bearing

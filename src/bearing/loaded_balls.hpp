#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "bearing/defect.hpp"
#include "bearing/geometry.hpp"
#include "bearing/kinematics.hpp"
#include "bearing/motion.hpp"

namespace piae::bearing {

/// One number for each of the courses that are solved side by side, a lane of the processor's
/// vectors each. Arithmetic is lane by lane: a course knows nothing of its neighbours.
using PerCourse = Vector<double>;
inline constexpr std::size_t courses_at_once = lanes<double>;

/// A ball on the loaded side. The inner ring's displacement s presses it by s * along - delta.
struct BallContact {
  PerCourse along;    ///< cos(psi_j) of its angle from the load direction; 0 outside the load zone
  PerCourse delta_m;  ///< eq. 11: clearance, and the defect's depth while it is in the defect
};

/// A direction in the plane of the bearing.
struct Direction {
  PerCourse cosine;
  PerCourse sine;
};

/// The balls that can carry load, from eqs 5 to 11. Outside the load zone (cos(psi_j) <= 0) a ball
/// cannot, so only the half turn from the zone's begin is looked at: the ball that entered last and
/// those ahead of it. Of a bearing with a roller defect one ball, the first, has it.
class LoadedBalls {
 public:
  /// Takes 1 to courses_at_once motions and as many clearances in m; the last of them fills the
  /// lanes that are left. Throws Error(bad_input) for a geometry, defect or motion that cannot be.
  LoadedBalls(const Geometry& geometry, const LocalDefect& defect, std::span<const Motion> motions,
              std::span<const double> clearances_m);

  /// Exactly, by the angles' cosines and sines, to this time.
  void set(double time_s);

  /// What advance() goes on by, from now on. Throws Error(bad_input) for a step in which more than
  /// one ball may enter the load zone.
  void set_step(double step_s);

  /// Goes on by rotations, each of which rounds by 1e-16: set() is due now and then.
  void advance();

  /// Where they are now, the ball that entered last first. Before the first set() they are nowhere.
  [[nodiscard]] std::span<const BallContact> contacts() const { return contacts_; }

 private:
  struct Ahead {
    double cosine;
    double sine;
  };

  void set_lane(std::size_t lane, double time_s);
  void find_contacts();

  Defect kind_;
  double ball_distance_rad_;
  std::vector<Ahead> ahead_;  ///< balls as seen from the one that entered last
  std::vector<Motion> motions_;
  std::vector<Speeds> speeds_;
  PerCourse clearance_m_{};
  PerCourse clearance_in_defect_m_{};

  // Eq. 9 by cosines: less than an angle apart is a cosine above its own. The defect is on a race,
  // or that of the ball which has it.
  double cosine_in_defect_;    ///< of the half angle that a ball's centre has to the defect
  double cosine_facing_race_;  ///< of twice the half angle on a ball; below -1 for a race

  Direction entered_{};      ///< the ball that entered last
  Direction from_defect_{};  ///< the same, as seen from the defect
  Direction strike_{};       ///< twice the spin angle less pi: 0 where the defect faces a race
  Direction entered_step_{};
  Direction from_defect_step_{};
  Direction strike_step_{};

  std::vector<BallContact> contacts_;
};

}  // namespace piae::bearing

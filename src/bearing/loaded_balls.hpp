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

/// One number for each course that is solved at the same time: each course has a lane of the
/// processor's vectors. Arithmetic is lane by lane, so courses do not affect each other.
using PerCourse = Vector<double>;
inline constexpr std::size_t courses_at_once = lanes<double>;

/// A ball in the load zone. The inner ring's displacement s compresses it by s * along - delta.
struct BallContact {
  PerCourse along;    ///< cos(psi_j) of its angle from the load direction; 0 outside the load zone
  PerCourse delta_m;  ///< eq. 11: the clearance, plus the defect's depth while the ball is in it
};

/// A direction in the plane of the bearing.
struct Direction {
  PerCourse cosine;
  PerCourse sine;
};

/// The balls that can carry load, from eqs 5 to 11. Outside the load zone (cos(psi_j) <= 0) a ball
/// does not carry load. So this class follows only the balls of half a turn: the ball that entered
/// the zone last and those ahead of it. In a bearing with a roller defect, the first ball has the
/// defect.
class LoadedBalls {
 public:
  /// Takes 1 to courses_at_once motions and the same number of clearances in m. The last motion and
  /// clearance fill the lanes that are left. Throws Error(bad_input) for an impossible geometry,
  /// defect or motion.
  LoadedBalls(const Geometry& geometry, const LocalDefect& defect, std::span<const Motion> motions,
              std::span<const double> clearances_m);

  /// Moves the balls to their positions at this time, exactly: by cosines and sines of their
  /// angles.
  void set(double time_s);

  /// Sets the time step of advance(). Throws Error(bad_input) for a step in which more than one
  /// ball might enter the load zone.
  void set_step(double step_s);

  /// Moves the balls on by one step, by rotations instead of cosines and sines. Each rotation
  /// rounds by 1e-16, so call set() regularly.
  void advance();

  /// Returns the current balls; the ball that entered the load zone last comes first. Undefined
  /// before the first set().
  [[nodiscard]] std::span<const BallContact> contacts() const { return contacts_; }

 private:
  /// Angle from the ball that entered last to a ball ahead of it; the same in all courses.
  struct Ahead {
    double cosine;
    double sine;
  };

  void set_lane(std::size_t lane, double time_s);
  void copy_lane(std::size_t from, std::size_t to);
  void find_contacts();

  Defect fault_type_;
  double ball_distance_rad_;
  std::vector<Ahead> ahead_;
  std::vector<Motion> motions_;
  std::vector<Speeds> speeds_;
  PerCourse clearance_m_{};
  PerCourse clearance_in_defect_m_{};

  // Cosines decide eq. 9: two directions are less than an angle apart if the cosine of their
  // difference exceeds the cosine of that angle. For a roller defect, "the defect" means the ball
  // that has it.
  double cosine_in_defect_;  ///< cosine of the largest angle between ball and defect at which they
                             ///< meet
  double cosine_facing_race_;  ///< cosine of twice the half angle on a ball; below -1 for a race

  Direction entered_{};      ///< the angle of the ball that entered last
  Direction from_defect_{};  ///< the angle from the defect to the ball that entered last
  Direction facing_{};       ///< twice the spin angle minus pi: 0 when the defect faces a race
  // Rotation of these three directions in one advance():
  Direction entered_step_{};
  Direction from_defect_step_{};
  Direction facing_step_{};

  std::vector<BallContact> contacts_;
};

}  // namespace piae::bearing

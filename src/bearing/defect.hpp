#pragma once

#include "bearing/geometry.hpp"

namespace piae::bearing {

/// Where a defect is; the paper's lambda_o, lambda_i and lambda_r (eq. 11). `other` is any fault
/// that is in no raceway and no ball, such as imbalance or looseness: nothing here says what it
/// does.
enum class Defect { none, outer, inner, roller, other };

/// Whether a defect is struck by balls, in the rhythm of the bearing's kinematics.
constexpr bool is_struck(Defect kind) { return kind != Defect::none && kind != Defect::other; }

/// A rectangular spall across the raceway or the ball.
struct LocalDefect {
  Defect kind = Defect::none;
  double size_mm = 0;  ///< L_o, L_i or L_r: its length along the running direction; 0 for none
};

/// Throws Error(bad_input) for an impossible defect. A healthy bearing must have size 0, and so
/// must one with a fault elsewhere. Any other must have a positive size that is below the ball's
/// diameter, so that the ball does not reach the bottom, and so small that only one ball at a time
/// is in the defect.
void validate(const Geometry& geometry, const LocalDefect& defect);

/// Eq. 8: half of the angle, in radians, that the defect spans as seen from the centre of the race
/// or ball; 0 for a healthy bearing.
double half_angle_rad(const Geometry& geometry, const LocalDefect& defect);

/// Eq. 10: how far a ball sinks into a defect of this size, in m. It is the same for all three
/// kinds.
double defect_depth_m(const Geometry& geometry, double size_mm);

/// An angle, in radians, brought to [-pi, pi].
double wrapped(double angle_rad);

/// Eq. 9: whether two directions are less than the half angle apart. As printed, eq. 9 takes each
/// angle mod 2 pi and then their difference, which is wrong across 0; here the difference is
/// wrapped.
bool meet(double angle_rad, double other_rad, double half_angle_rad);

/// Eq. 9, last case: a ball's defect faces a race twice a turn, at spin angles pi/2 and 3 pi/2.
bool faces_a_race(double spin_angle_rad, double half_angle_rad);

}  // namespace piae::bearing

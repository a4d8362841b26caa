#pragma once

#include "bearing/geometry.hpp"

namespace piae::bearing {

/// The place of a defect: lambda_o, lambda_i and lambda_r of the paper (eq. 11). `other` is a fault
/// of neither a raceway nor a ball, such as imbalance or looseness. No function here models it.
enum class Defect { none, outer, inner, roller, other };

/// True if balls cause impacts at the defect, at a rate that follows from the kinematics.
constexpr bool causes_impacts(Defect fault_type) {
  return fault_type != Defect::none && fault_type != Defect::other;
}

/// A rectangular spall across the raceway or the ball.
struct LocalDefect {
  Defect fault_type = Defect::none;
  double size_mm = 0;  ///< length along the running direction, L_o, L_i or L_r; 0 for none
};

/// Throws Error(bad_input) for an impossible defect. The size must be 0 for a healthy bearing and
/// for a fault elsewhere. Otherwise the size must be positive and below the ball's diameter, so
/// that the ball does not reach the bottom. A defect on a race may hold only one ball at a time.
void validate(const Geometry& geometry, const LocalDefect& defect);

/// Eq. 8: returns half of the angle, in radians, that the defect spans, seen from the centre of the
/// race or ball. Returns 0 for a healthy bearing.
double half_angle_rad(const Geometry& geometry, const LocalDefect& defect);

/// Eq. 10: returns the depth, in m, to which a ball sinks into a defect of this size. The depth is
/// the same on both races and on a ball.
double defect_depth_m(const Geometry& geometry, double size_mm);

/// Returns the angle, in radians, wrapped to [-pi, pi].
double wrapped(double angle_rad);

/// Eq. 9: true if two directions are less than the half angle apart. The printed eq. 9 takes each
/// angle mod 2 pi and then the difference, which is wrong across 0. This function wraps the
/// difference instead.
bool meet(double angle_rad, double other_rad, double half_angle_rad);

/// Eq. 9, last case: true if a ball's defect faces a race, near spin angles pi/2 and 3 pi/2.
bool faces_a_race(double spin_angle_rad, double half_angle_rad);

}  // namespace piae::bearing

#include "bearing/defect.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace piae::bearing {

namespace {

using std::numbers::pi;

/// Returns the diameter of the race or ball that has the defect (eq. 8).
double diameter_mm(const Geometry& g, Defect fault_type) {
  switch (fault_type) {
    case Defect::outer:
      return g.outer_raceway_mm;
    case Defect::inner:
      return g.inner_raceway_mm;
    default:
      return g.ball_diameter_mm;
  }
}

}  // namespace

void validate(const Geometry& g, const LocalDefect& defect) {
  if (!causes_impacts(defect.fault_type)) {
    if (defect.size_mm == 0) return;
    throw Error(Exit::bad_input,
                fmt::format("defect size {} mm in a bearing without a defect; it must be 0",
                            defect.size_mm));
  }
  if (!(defect.size_mm > 0 && defect.size_mm < g.ball_diameter_mm)) {
    throw Error(Exit::bad_input,
                fmt::format("defect size {} mm; it must lie between 0 and the ball's {} mm",
                            defect.size_mm, g.ball_diameter_mm));
  }
  const bool on_a_race = defect.fault_type != Defect::roller;
  if (on_a_race && half_angle_rad(g, defect) >= pi / g.balls) {
    throw Error(
        Exit::bad_input,
        fmt::format("defect size {} mm spans more than the distance between two balls; it must "
                    "be below {:.3g} mm",
                    defect.size_mm, diameter_mm(g, defect.fault_type) * std::sin(pi / g.balls)));
  }
}

double half_angle_rad(const Geometry& g, const LocalDefect& defect) {
  return std::asin(defect.size_mm / diameter_mm(g, defect.fault_type));
}

double defect_depth_m(const Geometry& g, double size_mm) {
  const double radius = g.ball_diameter_mm / 2;
  return (radius - std::sqrt(radius * radius - size_mm * size_mm / 4)) * 1e-3;
}

double wrapped(double angle_rad) { return angle_rad - 2 * pi * std::rint(angle_rad / (2 * pi)); }

bool meet(double angle_rad, double other_rad, double half_angle_rad) {
  return std::abs(wrapped(angle_rad - other_rad)) < half_angle_rad;
}

bool faces_a_race(double spin_angle_rad, double half_angle_rad) {
  // Twice the spin angle is pi (mod 2 pi) at both of these angles.
  return meet(2 * spin_angle_rad, pi, 2 * half_angle_rad);
}

}  // namespace piae::bearing

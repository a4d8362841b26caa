#include "bearing/kinematics.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace piae::bearing {

namespace {

using std::numbers::pi;

void require(bool holds, const std::string& what) {
  if (!holds) throw Error(Exit::bad_input, "bearing: " + what);
}

}  // namespace

void validate(const Geometry& g) {
  require(g.balls >= 3, fmt::format("{} balls; 3 or more are needed", g.balls));
  // These comparisons also fail for a NaN.
  require(g.ball_diameter_mm > 0 && std::isfinite(g.pitch_diameter_mm),
          "diameters must be positive and finite");
  require(g.ball_diameter_mm < g.pitch_diameter_mm * std::sin(pi / g.balls),
          fmt::format("{} balls of {} mm do not fit on a pitch circle of {} mm", g.balls,
                      g.ball_diameter_mm, g.pitch_diameter_mm));
  require(
      g.inner_raceway_mm > 0 && g.inner_raceway_mm < g.pitch_diameter_mm &&
          g.pitch_diameter_mm < g.outer_raceway_mm && std::isfinite(g.outer_raceway_mm),
      fmt::format("inner raceway {} mm, pitch circle {} mm and outer raceway {} mm must grow in "
                  "this order",
                  g.inner_raceway_mm, g.pitch_diameter_mm, g.outer_raceway_mm));
  require(g.contact_angle_deg >= 0 && g.contact_angle_deg < 90,
          fmt::format("contact angle {} degrees; it must lie in [0, 90)", g.contact_angle_deg));
}

Speeds speeds(const Geometry& g, double shaft_speed_rpm, double slip) {
  const double ratio =
      g.ball_diameter_mm / g.pitch_diameter_mm * std::cos(g.contact_angle_deg * pi / 180);
  Speeds speeds;
  speeds.shaft = shaft_speed_rpm * 2 * pi / 60;
  speeds.cage = speeds.shaft / 2 * (1 - ratio) * (1 - slip);
  speeds.spin = speeds.shaft / 2 * g.pitch_diameter_mm / g.ball_diameter_mm * (1 - ratio * ratio) *
                (1 - slip);
  return speeds;
}

FaultFrequencies fault_frequencies(const Geometry& g, double shaft_speed_rpm, double slip) {
  const Speeds s = speeds(g, shaft_speed_rpm, slip);
  FaultFrequencies f;
  f.shaft_hz = s.shaft / (2 * pi);
  f.cage_hz = s.cage / (2 * pi);
  f.bpfo_hz = g.balls * f.cage_hz;
  f.bpfi_hz = g.balls * (f.shaft_hz - f.cage_hz);
  f.bsf_hz = s.spin / (2 * pi);
  return f;
}

}  // namespace piae::bearing

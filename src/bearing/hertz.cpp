#include "bearing/hertz.hpp"

#include <spdlog/fmt/fmt.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/error.hpp"
#include "bearing/kinematics.hpp"

namespace piae::bearing {

namespace {

using std::numbers::pi;

/// Returns the curvature. `along` is its part in the running direction: +2 g / (1 - g) on the inner
/// race and -2 g / (1 + g) on the outer race, with g = d cos(alpha) / D.
Curvature curvature(double along, const Geometry& g, const HertzOptions& options) {
  const double across = 1 / options.groove_ratio;
  const double sum = 4 - across + along;
  return {.sum_per_m = sum / (g.ball_diameter_mm * 1e-3), .difference = (across + along) / sum};
}

double pitch_ratio(const Geometry& g) {
  return g.ball_diameter_mm * std::cos(g.contact_angle_deg * pi / 180) / g.pitch_diameter_mm;
}

struct Ellipse {
  double first;   // complete elliptic integral of the first kind, Harris's F
  double second;  // complete elliptic integral of the second kind, E
};

Ellipse integrals(double axis_ratio) {
  const double modulus = std::sqrt(1 - 1 / (axis_ratio * axis_ratio));
  return {boost::math::ellint_1(modulus), boost::math::ellint_2(modulus)};
}

double difference_of(double axis_ratio) {
  const Ellipse e = integrals(axis_ratio);
  const double k2 = axis_ratio * axis_ratio;
  return ((k2 + 1) * e.second - 2 * e.first) / ((k2 - 1) * e.second);
}

double axis_ratio_for(double difference) {
  constexpr double round = 1 + 1e-6;  // closer to 1, rounding destroys the difference
  constexpr double longest = 1e6;     // a groove that fits the ball to within 1e-11
  if (difference <= difference_of(round)) return round;
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      [difference](double ratio) { return difference_of(ratio) - difference; }, round, longest,
      boost::math::tools::eps_tolerance<double>(45), iterations);
  return (bracket.first + bracket.second) / 2;
}

void validate_hertz(const HertzOptions& o) {
  if (!(o.youngs_modulus_pa > 0 && std::isfinite(o.youngs_modulus_pa))) {
    throw Error(Exit::bad_input, "Young's modulus must be positive and finite");
  }
  if (!(o.poissons_ratio >= 0 && o.poissons_ratio <= 0.5)) {
    throw Error(Exit::bad_input,
                fmt::format("Poisson's ratio {}; it must lie in [0, 0.5]", o.poissons_ratio));
  }
  if (!(o.groove_ratio >= 0.501 && o.groove_ratio <= 1)) {
    throw Error(Exit::bad_input,
                fmt::format("groove radius of {} ball diameters; it must lie in [0.501, 1]",
                            o.groove_ratio));
  }
}

}  // namespace

Curvature inner_curvature(const Geometry& g, const HertzOptions& options) {
  const double ratio = pitch_ratio(g);
  return curvature(2 * ratio / (1 - ratio), g, options);
}

Curvature outer_curvature(const Geometry& g, const HertzOptions& options) {
  const double ratio = pitch_ratio(g);
  return curvature(-2 * ratio / (1 + ratio), g, options);
}

double contact_deformation(double curvature_difference) {
  const double ratio = axis_ratio_for(curvature_difference);
  const Ellipse e = integrals(ratio);
  return 2 * e.first / pi * std::cbrt(pi / (2 * ratio * ratio * e.second));
}

double race_stiffness(const Curvature& c, const HertzOptions& o) {
  const double deformation = contact_deformation(c.difference);
  return 2 * std::numbers::sqrt2 * o.youngs_modulus_pa /
         (3 * (1 - o.poissons_ratio * o.poissons_ratio) *
          std::sqrt(deformation * deformation * deformation * c.sum_per_m));
}

double contact_stiffness(const Geometry& g, const HertzOptions& options) {
  validate(g);
  validate_hertz(options);
  const double inner = race_stiffness(inner_curvature(g, options), options);
  const double outer = race_stiffness(outer_curvature(g, options), options);
  const double give = std::pow(inner, -2.0 / 3) + std::pow(outer, -2.0 / 3);
  return std::pow(give, -1.5);
}

}  // namespace piae::bearing

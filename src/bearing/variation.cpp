#include "bearing/variation.hpp"

#include <cmath>
#include <numbers>

namespace piae::bearing {

namespace {

/// Normal deviations are cut off at this number of standard deviations.
constexpr double cut_at = 1 / spread_limit;

double draw(Stream& stream, double mean, double spread) {
  for (;;) {
    const double deviation = stream.normal(0, 1);
    if (std::abs(deviation) <= cut_at) return mean * (1 + spread * deviation);
  }
}

double draw_angle(Stream& stream) { return stream.uniform(0, 2 * std::numbers::pi); }

}  // namespace

double largest_lift_n(const DynamicsOptions& mean, const Variation& variation) {
  const double stiffest = mean.stiffness_n_per_m * (1 + cut_at * variation.stiffness_spread);
  return stiffest * mean.clearance_um * 1e-6;
}

DynamicsOptions draw_dynamics(Stream& stream, const DynamicsOptions& mean,
                              const Variation& variation) {
  DynamicsOptions drawn = mean;
  drawn.stiffness_n_per_m = draw(stream, mean.stiffness_n_per_m, variation.stiffness_spread);
  drawn.damping_ns_per_m = draw(stream, mean.damping_ns_per_m, variation.damping_spread);
  return drawn;
}

Motion draw_motion(Stream& stream, Defect defect, double mean_speed_rpm,
                   const Variation& variation) {
  Motion motion;
  motion.shaft_speed_rpm = draw(stream, mean_speed_rpm, variation.speed_spread);
  motion.slip = variation.slip_max * stream.uniform(0, 1);
  motion.cage_angle_rad = draw_angle(stream);
  if (defect != Defect::outer) motion.defect_angle_rad = draw_angle(stream);
  return motion;
}

}  // namespace piae::bearing

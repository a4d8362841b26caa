#include "zero/load.hpp"

#include <cmath>
#include <numbers>

#include "bearing/load_zone.hpp"
#include "zero/draws.hpp"

namespace piae::zero {

double Load::at(double time_s) const {
  const double stays = extent > 0 ? bearing::load_share(angle_rad + rad_per_s * time_s, extent) : 1;
  return stays * (1 + rotating * std::cos(shaft_angle_rad + shaft_rad_per_s * time_s));
}

Load draw_load(bearing::Defect defect, const bearing::Speeds& speeds, const Prior& prior,
               Stream& random) {
  const double turn = 2 * std::numbers::pi;
  const bool stays = defect == bearing::Defect::outer;
  const double widest = stays ? prior.outer_angle_rad : turn / 2;
  Load load;
  load.extent = log_evenly(random, prior.least_extent, prior.largest_extent);
  if (prior.load_zone == Switch::off) load.extent = 0;
  load.angle_rad = evenly(random, -widest, widest);
  load.rotating = random.uniform(0, 1) * prior.rotating;
  load.shaft_angle_rad = random.uniform(0, turn);
  load.shaft_rad_per_s = speeds.shaft;
  if (defect == bearing::Defect::inner) {
    load.rad_per_s = speeds.shaft;
    load.rotating = 0;
  } else if (!stays) {
    load.rad_per_s = speeds.cage;
  }
  return load;
}

void apply_load(const Load& load, const Prior& prior, Stream& random,
                std::vector<transfer::Strike>& strikes) {
  const double scatter = random.uniform(0, 1) * prior.strength_scatter;
  for (transfer::Strike& strike : strikes) {
    strike.strength *= load.at(strike.time_s) * std::exp(random.normal(0, scatter));
  }
}

}  // namespace piae::zero

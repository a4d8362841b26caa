#include "impacts/strengths.hpp"

#include <algorithm>
#include <cmath>

#include "impacts/ranges.hpp"

namespace piae::impacts {

double load_share(double angle_rad, double extent) {
  return std::pow(std::max(0.0, 1 - (1 - std::cos(angle_rad)) / (2 * extent)), 1.5);
}

void add_to(cli::StoredOptions& table, LoadOptions& o, const std::array<const char*, 4>& stored) {
  table.add("load-zone-from", o.least_extent, ranges::extent,
            "least extent of the load zone: 0.5 is half a turn, less with clearance", stored[0]);
  table.add("load-zone-to", o.largest_extent, ranges::extent,
            "largest extent of the load zone: more than 0.5 with preload", stored[1]);
  table.add("rotating-load", o.rotating, ranges::part,
            "largest load that turns with the shaft / load that stays", stored[2]);
  table.add("strength-scatter", o.scatter, ranges::scatter,
            "largest standard deviation of the logarithm of an impact's strength", stored[3]);
}

double Load::at(double time_s) const {
  const double stays = extent > 0 ? load_share(angle_rad + rad_per_s * time_s, extent) : 1;
  return stays * (1 + rotating * std::cos(shaft_angle_rad + shaft_rad_per_s * time_s));
}

Load load_on(bearing::Defect defect, const bearing::Speeds& speeds, double rotating) {
  Load load{.rotating = rotating, .shaft_rad_per_s = speeds.shaft};
  if (defect == bearing::Defect::inner) {
    load.rad_per_s = speeds.shaft;
    load.rotating = 0;
  } else if (defect == bearing::Defect::roller) {
    load.rad_per_s = speeds.cage;
  }
  return load;
}

void apply_load(const Load& load, double scatter, Stream& random, std::vector<Impact>& impacts) {
  for (Impact& impact : impacts) {
    impact.strength *= load.at(impact.time_s) * std::exp(random.normal(0, scatter));
  }
}

void weaken_every_second(double factor, std::size_t first, std::vector<Impact>& impacts) {
  for (std::size_t i = first; i < impacts.size(); i += 2) impacts[i].strength *= factor;
}

}  // namespace piae::impacts

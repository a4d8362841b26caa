#include "transfer/strengths.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace piae::transfer {

std::vector<double> load_zone_strengths(bearing::Defect fault_type, const bearing::Speeds& speeds,
                                        double period_s, std::size_t count,
                                        const impacts::LoadOptions& options, Stream& random) {
  const double extent =
      std::lerp(options.least_extent, options.largest_extent, random.uniform(0, 1));
  const double scatter = random.uniform(0, 1) * options.scatter;
  impacts::Load load =
      impacts::load_on(fault_type, speeds, random.uniform(0, 1) * options.rotating);
  const double other_race = random.uniform(0, 1);
  load.extent = extent;
  if (load.rad_per_s > 0) load.angle_rad = random.uniform(0, 2 * std::numbers::pi);
  load.shaft_angle_rad = random.uniform(0, 2 * std::numbers::pi);
  std::vector<impacts::Impact> impacts(count);
  for (std::size_t i = 0; i < count; ++i) impacts[i].time_s = period_s * static_cast<double>(i);
  impacts::apply_load(load, scatter, random, impacts);
  if (fault_type == bearing::Defect::roller) impacts::weaken_every_second(other_race, 1, impacts);
  std::vector<double> strengths;
  strengths.reserve(count);
  for (const impacts::Impact& impact : impacts) strengths.push_back(impact.strength);
  // The defect may stay outside the load zone during a short window, which would then be silent.
  if (std::ranges::max(strengths) <= 0) std::ranges::fill(strengths, 1.0);
  return strengths;
}

std::vector<double> repeated_strengths(std::span<const double> known, std::size_t count,
                                       Stream& random) {
  const std::size_t first = random.below(known.size());
  std::vector<double> strengths(count);
  for (std::size_t i = 0; i < count; ++i) strengths[i] = known[(first + i) % known.size()];
  return strengths;
}

}  // namespace piae::transfer

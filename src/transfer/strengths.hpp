#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "bearing/defect.hpp"
#include "bearing/kinematics.hpp"

namespace piae::transfer {

/// Source of the strengths of impacts: a known window, as long as its own bearing is the tested
/// one, which is loaded as it was; the load zone (impacts/strengths.hpp); or all are alike.
enum class Strengths { known, load_zone, alike };

struct StrengthOptions {
  Strengths from = Strengths::known;
  double least_extent = 0.2;  ///< of the load zone, drawn for each window
  double largest_extent = 1;
  double rotating = 0;  ///< load that turns with the shaft / load that stays: the largest
  double scatter = 0;   ///< of an impact's logarithm: largest standard deviation
};

/// The strengths of `count` impacts, `period_s` apart. A defect of the outer race is in the middle
/// of the load zone, others begin anywhere. The extent of the zone, a load that turns with the
/// shaft, the part by which a ball is weaker on one race, and the standard deviation of single
/// impacts are uniform within the options. At least one strength is positive.
std::vector<double> load_zone_strengths(bearing::Defect kind, const bearing::Speeds& speeds,
                                        double period_s, std::size_t count,
                                        const StrengthOptions& options, Stream& random);

/// `count` strengths in the order of those given, from a random one on, again and again. There must
/// be one.
std::vector<double> repeated_strengths(std::span<const double> known, std::size_t count,
                                       Stream& random);

}  // namespace piae::transfer

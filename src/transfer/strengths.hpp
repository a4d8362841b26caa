#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "impacts/strengths.hpp"

namespace piae::transfer {

/// Source of the strengths of impacts: a known window, as long as its own bearing is the tested
/// one, which is loaded as it was; the load zone (impacts/strengths.hpp); or all are alike.
enum class Strengths { known, load_zone, alike };

struct StrengthOptions {
  Strengths from = Strengths::known;
  impacts::LoadOptions load{.least_extent = 0.2, .largest_extent = 1};
};

/// The strengths of `count` impacts, `period_s` apart. A defect of the outer race is in the middle
/// of the load zone, others begin anywhere. The extent of the zone, a load that turns with the
/// shaft, the part by which a ball is weaker on one race, and the standard deviation of single
/// impacts are uniform within the options. At least one strength is positive.
std::vector<double> load_zone_strengths(bearing::Defect kind, const bearing::Speeds& speeds,
                                        double period_s, std::size_t count,
                                        const impacts::LoadOptions& options, Stream& random);

/// `count` strengths in the order of those given, from a random one on, again and again. There must
/// be one.
std::vector<double> repeated_strengths(std::span<const double> known, std::size_t count,
                                       Stream& random);

}  // namespace piae::transfer

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "impacts/strengths.hpp"

namespace piae::transfer {

/// Source of the strengths of impacts: a known window, if its own bearing is tested, which has the
/// same load; the load zone (impacts/strengths.hpp); or equal strengths.
enum class Strengths { known, load_zone, alike };

struct StrengthOptions {
  Strengths from = Strengths::known;
  impacts::LoadOptions load{.least_extent = 0.2, .largest_extent = 1};
};

/// Returns the strengths of `count` impacts, `period_s` apart. A defect of the outer race is in the
/// middle of the load zone; others start at any angle. Four values are uniform within the options:
/// the extent of the zone, the load that turns with the shaft, the factor of a ball's weaker race,
/// and the standard deviation of single impacts. At least one strength is positive.
std::vector<double> load_zone_strengths(bearing::Defect fault_type, const bearing::Speeds& speeds,
                                        double period_s, std::size_t count,
                                        const impacts::LoadOptions& options, Stream& random);

/// Returns `count` strengths: those of `known` in their order, cyclically, from a random one on.
/// `known` must not be empty.
std::vector<double> repeated_strengths(std::span<const double> known, std::size_t count,
                                       Stream& random);

}  // namespace piae::transfer

#pragma once

#include "bearing/defect.hpp"
#include "bearing/geometry.hpp"

namespace piae::bearing {

/// Returns the impact rate of a local defect, in Hz, at this shaft speed and without slip: BPFO,
/// BPFI, or 2 BSF for a roller, whose defect hits both races in each turn (the real ball faults of
/// CWRU do not have a line at the odd multiples of BSF). Returns 0 for a healthy bearing.
double impact_frequency_hz(const Geometry& geometry, Defect fault_type, double shaft_speed_rpm);

/// Returns the time between the impacts at the two edges of the defect, in s: the angle of eq. 8
/// divided by the speed at which the balls pass the race (for a roller, by its spin). The time is
/// inversely proportional to the shaft speed. Returns 0 for a healthy bearing.
double passage_s(const Geometry& geometry, const LocalDefect& defect, double shaft_speed_rpm);

}  // namespace piae::bearing

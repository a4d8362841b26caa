#pragma once

#include "bearing/defect.hpp"
#include "bearing/geometry.hpp"

namespace piae::bearing {

/// How often a local defect is struck, in Hz, at this speed of the shaft and without slip: BPFO,
/// BPFI, or 2 BSF for a roller, whose defect strikes both races in each turn (the real ball faults
/// of CWRU have no line at the odd multiples of BSF). 0 for a healthy bearing.
double strike_frequency_hz(const Geometry& geometry, Defect kind, double shaft_speed_rpm);

/// How long a strike lasts, in s: the time between both edges of the defect, which is the angle of
/// eq. 8 by the speed at which the balls pass the race (or, of a roller, at which it spins). It is
/// inversely proportional to the shaft's speed. 0 for a healthy bearing.
double passage_s(const Geometry& geometry, const LocalDefect& defect, double shaft_speed_rpm);

}  // namespace piae::bearing

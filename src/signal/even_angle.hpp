#pragma once

#include <span>
#include <vector>

#include "signal/speed_course.hpp"

namespace piae::signal {

/// Returns as many samples as the signal has, at even steps of the shaft's angle instead of time
/// (order tracking: Fyfe and Munck 1997), by linear interpolation. At the same sample rate, the
/// lines of the shaft and of its bearing then lie where they would lie at the mean speed.
std::vector<double> at_even_angle(std::span<const double> signal, double rate_hz,
                                  const SpeedCourse& speeds);

}  // namespace piae::signal

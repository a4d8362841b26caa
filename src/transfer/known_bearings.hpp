#pragma once

#include <cstddef>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::transfer {

/// Known windows of one bearing in one condition: of one class, speed and size.
struct KnownBearing {
  Label label = 0;
  double speed_rpm = 0;
  double size_mm = 0;
  std::vector<std::size_t> windows;  ///< indices in their set, ascending
};

/// By class, then by speed, then by size.
std::vector<KnownBearing> bearings_of(const signal::WindowSet& known);

/// True if bearings are tested that are not known: if the records of a class hold several sizes,
/// each is of a bearing of its own, and a condition in which none is known has others.
bool tests_other_bearings(const signal::WindowSet& known);

/// The time from impact to impact in known window i, if the shaft turned at this speed.
double period_s(const signal::WindowSet& known, std::size_t i, double rpm);

/// How long a ball would be over a defect of this size (bearing/strikes.hpp) in known window i, if
/// the shaft turned at this speed.
double passage_s(const signal::WindowSet& known, std::size_t i, double size_mm, double rpm);

/// Throws Error(bad_input) if impacts of a known defect come more often than every two samples, at
/// its own speed or at a tested one: windows cannot show such a rate.
void require_rate(const signal::WindowSet& known);

}  // namespace piae::transfer

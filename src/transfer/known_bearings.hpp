#pragma once

#include <cstddef>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::transfer {

/// Known windows of one bearing: of one class, condition and size. Its records may differ a little
/// in speed.
struct KnownBearing {
  Label label = 0;
  double speed_rpm = 0;  ///< the mean over its windows
  double size_mm = 0;
  std::vector<std::size_t> windows;  ///< indices in their set, ascending
};

/// Returns the known bearings by class, then by condition, then by size.
std::vector<KnownBearing> bearings_of(const signal::WindowSet& known);

/// True if the tested bearings are not the known ones: windows have sizes of their own (each size
/// is a separate bearing), and a tested condition is not known.
bool tests_other_bearings(const signal::WindowSet& known);

/// Returns the time between impacts of known window i's defect at this shaft speed.
double period_s(const signal::WindowSet& known, std::size_t i, double rpm);

/// Returns the time that a ball takes to pass a defect of this size (bearing/impact_frequency.hpp)
/// in known window i, at this shaft speed.
double passage_s(const signal::WindowSet& known, std::size_t i, double size_mm, double rpm);

/// Throws Error(bad_input) if impacts of a known defect come more often than every two samples, at
/// its own or a tested speed, because windows cannot show such a rate.
void require_rate(const signal::WindowSet& known);

}  // namespace piae::transfer

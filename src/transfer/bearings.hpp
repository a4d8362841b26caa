#pragma once

#include <Eigen/Core>
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

/// Whether bearings are tested that are not known: where the records of a class hold several sizes,
/// each is of a bearing of its own, and a condition in which none is known has others.
bool tests_other_bearings(const signal::WindowSet& known);

/// The logarithm (natural) of the amplitude of a bearing's windows, at the bins 0 .. length of a
/// frame of two windows (of one sample more, where the length is odd). It is Welch's mean, of
/// pieces of half a window that overlap by three quarters.
Eigen::ArrayXd log_amplitude(const signal::WindowSet& known, const KnownBearing& bearing);

}  // namespace piae::transfer

#pragma once

#include <cstddef>
#include <optional>

#include "bearing/geometry.hpp"

namespace piae::inspection {

// Checks of a description's numbers that follow from physics or counting.

/// True if a speed in rpm is more likely in Hz: between 1 and 100. Machines with monitored bearings
/// turn at hundreds to thousands of rpm, that is 1 to 100 times a second.
bool looks_like_hz(double shaft_speed_rpm);

/// Raceways that do not fit the balls.
struct RacewayMismatch {
  double gap_mm = 0;       ///< half the difference of the raceways; should be the ball's diameter
  double mean_mm = 0;      ///< of both raceways; should be the pitch diameter
  bool too_wide = false;   ///< gap wider than the balls: bore and outside diameter?
  bool too_tight = false;  ///< gap narrower than the balls: shoulders of the raceways?
};

/// Returns the mismatch, or nothing if the raceways are plausible. The tolerance is a tenth of the
/// ball's diameter. Play takes less than a hundredth and rounding in catalogues a thirtieth. Bore
/// and outside diameter are about seven tenths of a ball farther apart (SKF 6205: 25 and 52 mm for
/// a ball of 7.94 mm), because each ring is a third of a ball thick. With a contact angle, raceways
/// may be given at the contact points, which are closer by its cosine.
std::optional<RacewayMismatch> raceway_mismatch(const bearing::Geometry& geometry);

/// Returns the share of test windows that share samples with a training window, if `windows` of one
/// long record are assigned at random and `training` of them are for training. Of the n - 1 other
/// windows, 2 k overlap a window, with k = (window - 1) / stride on either side. None of these is
/// among the t training windows with the probability C(n - 1 - 2 k, t) / C(n - 1, t).
double share_that_meets_training(std::size_t stride, std::size_t window, std::size_t windows,
                                 std::size_t training);

}  // namespace piae::inspection

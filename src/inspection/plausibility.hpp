#pragma once

#include <cstddef>
#include <optional>

#include "bearing/geometry.hpp"

namespace piae::inspection {

// What numbers of a description can hardly be. All of it follows from physics or from counting.

/// Whether a speed in rpm is more likely one in Hz: between 1 and 100. Machines whose bearings are
/// watched by vibration turn at hundreds to thousands of rpm, that is 1 to 100 times a second.
bool looks_like_hz(double shaft_speed_rpm);

/// Raceways between which the balls would not fit.
struct RacewayMismatch {
  double gap_mm = 0;       ///< half the difference of the raceways; the ball's diameter in truth
  double mean_mm = 0;      ///< of both raceways; the pitch diameter in truth
  bool too_wide = false;   ///< the balls would rattle: bore and outside diameter?
  bool too_tight = false;  ///< they would not fit in: the shoulders beside the raceways?
};

/// None where the raceways can be those of this bearing. A tenth of the ball's diameter is allowed:
/// play takes less than a hundredth and the rounding of catalogues a thirtieth, but bore and
/// outside diameter are some seven tenths of a ball farther apart (SKF 6205: 25 and 52 mm for a
/// ball of 7.94 mm), since each ring is a third of a ball thick. With a contact angle, raceways may
/// be given where balls touch them, which is closer by its cosine.
std::optional<RacewayMismatch> raceway_mismatch(const bearing::Geometry& geometry);

/// The part of the test windows that share samples with at least one training window, where
/// `windows` of one long record are dealt out at random and `training` of them are for training.
/// Of the n - 1 others, 2 k overlap a window, k = (window - 1) / stride on either side, and none of
/// these is among the t for training with the probability C(n - 1 - 2 k, t) / C(n - 1, t).
double share_that_meets_training(std::size_t stride, std::size_t window, std::size_t windows,
                                 std::size_t training);

}  // namespace piae::inspection

#pragma once

#include <Eigen/Core>

#include "base/random.hpp"
#include "transfer/options.hpp"

namespace piae::transfer {

/// A random transfer path, at the bins 0 .. length of a frame of two windows: the difference
/// between tested and known condition in addition to kinematics.
struct Path {
  Eigen::ArrayXd log_gain;  ///< natural logarithm
  Eigen::ArrayXd phase;     ///< rad
};

/// Draws a path. The gain is that of a random equaliser (impacts/path.hpp), times a power of the
/// frequency. A faster impact is sharper, so the spectrum grows with the frequency, by a power that
/// is drawn between 0 and `tilt` per doubling of the speed. The group delay is normal at the
/// equaliser's knots and linear between them. The path to another bearing has its own standard
/// deviation.
Path draw_path(Stream& random, Eigen::Index bins, double rate_hz, double speed_ratio,
               bool to_other_bearing, const CarryOptions& options);

/// Returns the minimum-phase response through a path.
Eigen::ArrayXcd response_behind(const Path& path, const Eigen::ArrayXd& log_response);

}  // namespace piae::transfer

#pragma once

#include <Eigen/Core>

#include "base/random.hpp"
#include "transfer/options.hpp"

namespace piae::transfer {

/// A random transfer path, at the bins 0 .. length of a frame of two windows: how the tested
/// condition may differ from the known one in addition to what kinematics says.
struct Path {
  Eigen::ArrayXd log_gain;  ///< natural logarithm
  Eigen::ArrayXd phase;     ///< rad
};

/// The gain is that of a random equaliser (impacts/path.hpp), times a power of the frequency: a
/// faster impact is sharper, so the spectrum grows with the frequency, by a power that is drawn
/// between 0 and `tilt` for a doubled speed. The group delay is normal at the equaliser's knots, a
/// straight line between them. The path of another bearing differs by its own standard deviation.
Path draw_path(Stream& random, Eigen::Index bins, double rate_hz, double speed_ratio,
               bool to_other_bearing, const CarryOptions& options);

/// The response of minimum phase behind a path.
Eigen::ArrayXcd response_behind(const Path& path, const Eigen::ArrayXd& log_response);

}  // namespace piae::transfer

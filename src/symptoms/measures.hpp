#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "signal/window_set.hpp"
#include "symptoms/line_heights.hpp"

namespace piae::symptoms {

/// What one window shows by itself, before it is compared with healthy ones. All of it is the same
/// for a window that is louder or has an offset.
struct Measures {
  /// The height of the line of each kind over four harmonics, at least -1 (line_heights.hpp).
  std::array<double, number_of_kinds> lines{};
  /// The height over 1 .. 4 harmonics, [kind][harmonics - 1], clipped to at least -0.5.
  std::array<std::array<double, most_harmonics>, number_of_kinds> heights{};
  double log_kurtosis = 0;  ///< ln(mean of the 4th power / squared mean of the 2nd), about the mean
  Eigen::ArrayXd shape_db;  ///< [48] of the spectrum (band_levels.hpp)
  Eigen::ArrayXd levels_db;  ///< [bands] (band_levels.hpp)
};

/// The measures of each window, at the speed of the shaft in it. `what` names the set in errors,
/// such as "--test". Throws Error(bad_input) for a bearing that cannot be (bearing/kinematics.hpp);
/// for a speed that is not above 0, or so high that harmonics of a line lie above half the sample
/// rate; for a sample rate below 1800 Hz; for a constant window; and for windows too short to tell
/// the lines apart: the fourth harmonics of any two must lie two bins of the spectrum apart, the
/// half width of a line under Hann's window. For a 6205 that takes 0.71 turns of the shaft.
std::vector<Measures> measure(const signal::WindowSet& windows, const std::string& what);

}  // namespace piae::symptoms

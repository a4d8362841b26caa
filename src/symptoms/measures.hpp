#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "bearing/defect.hpp"
#include "bearing/geometry.hpp"
#include "signal/window_set.hpp"

namespace piae::symptoms {

/// The kinds of defects, in the order in which they stand everywhere here.
inline constexpr std::array kinds{bearing::Defect::inner, bearing::Defect::roller,
                                  bearing::Defect::outer};
inline constexpr std::size_t number_of_kinds = kinds.size();

/// How many harmonics of a line count at most.
inline constexpr int most_harmonics = 4;

/// How often a defect of each kind is struck in a turn of the shaft, without slip: BPFI, 2 BSF and
/// BPFO by the frequency of the shaft.
std::array<double, number_of_kinds> line_orders(const bearing::Geometry& geometry);

/// What one window shows by itself, before it is compared with healthy ones. All of it is the same
/// for a window that is louder or has an offset.
struct Measures {
  /// The height of the line of each kind over four harmonics, at least -1
  /// (spectra::common_slip_height()).
  std::array<double, number_of_kinds> lines{};
  /// The height over 1 .. 4 harmonics, [kind][harmonics - 1], clipped to at least -0.5.
  std::array<std::array<double, most_harmonics>, number_of_kinds> heights{};
  double log_kurtosis = 0;  ///< ln(mean of the 4th power / squared mean of the 2nd), about the mean
  Eigen::ArrayXd shape_db;  ///< [48] of the spectrum (spectra/bands.hpp)
  Eigen::ArrayXd levels_db;  ///< [bands] (spectra/bands.hpp)
};

/// The measures of each window, at the speed of the shaft in it. `what` names the set in errors,
/// such as "--test". Throws Error(bad_input) for a bearing that cannot be (bearing/kinematics.hpp);
/// for a speed that is not above 0, or so high that harmonics of a line lie above half the sample
/// rate; for a sample rate below 1800 Hz; for a constant window; and for windows too short to tell
/// the lines apart: the fourth harmonics of any two must lie two bins of the spectrum apart, the
/// half width of a line under Hann's window. For a 6205 that takes 0.71 turns of the shaft.
std::vector<Measures> measure(const signal::WindowSet& windows, const std::string& what);

}  // namespace piae::symptoms

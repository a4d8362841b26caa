#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "base/range.hpp"
#include "bearing/defect.hpp"
#include "bearing/geometry.hpp"
#include "signal/window_set.hpp"

namespace piae::symptoms {

/// Fault types, in the order used everywhere in this room.
inline constexpr std::array fault_types{bearing::Defect::inner, bearing::Defect::roller,
                                        bearing::Defect::outer};
inline constexpr std::size_t number_of_fault_types = fault_types.size();

/// Largest number of harmonics used for a line.
inline constexpr int most_harmonics = 4;

/// Returns the impacts per shaft turn for a defect of each type, without slip: BPFI, 2 BSF and BPFO
/// divided by the shaft frequency.
std::array<double, number_of_fault_types> line_orders(const bearing::Geometry& geometry);

/// Measures of one window, before it is compared with healthy ones. Neither level nor offset of the
/// window affects them.
struct Measures {
  /// Height of each fault type's line over four harmonics, at least -1
  /// (spectra::common_slip_height()).
  std::array<double, number_of_fault_types> lines{};
  /// Height over 1 .. 4 harmonics, [kind][harmonics - 1], clipped to at least -0.5.
  std::array<std::array<double, most_harmonics>, number_of_fault_types> heights{};
  double log_kurtosis = 0;  ///< ln(mean of the 4th power / squared mean of the 2nd), about the mean
  Eigen::ArrayXd shape_db;  ///< [48] of the spectrum (spectra/bands.hpp)
  Eigen::ArrayXd levels_db;  ///< [bands] (spectra/bands.hpp)
};

/// Values of `prewhitening` (spectra::order_spectrum()).
inline constexpr Range possible_prewhitening{.low = 0, .high = 1};

/// Returns the measures of each window at its shaft speed. `what` names the set in errors, such as
/// "--test". Throws Error(bad_input) for an impossible bearing (bearing/kinematics.hpp); for a
/// speed that is not above 0, or so high that harmonics of a line lie above half the sample rate;
/// for a sample rate below 1800 Hz; for a constant window; and for windows too short to separate
/// the lines: the fourth harmonics of any two must lie two bins of the spectrum apart, the half
/// width of a line under Hann's window. A 6205 needs 0.71 turns of the shaft.
std::vector<Measures> measure(const signal::WindowSet& windows, const std::string& what,
                              double prewhitening = 0);

/// Returns the number of shaft turns that a window needs to separate the lines (measure());
/// infinite if two lines coincide.
double fewest_turns(const bearing::Geometry& geometry);

}  // namespace piae::symptoms

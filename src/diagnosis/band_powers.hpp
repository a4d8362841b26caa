#pragma once

#include <Eigen/Core>

#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// One row for each window.
using BandPowers = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Returns [n, 128]: the logarithm of each window's power in 128 bands of equal width under Hann's
/// window, without the bin of the offset. The mean over the bands is removed, so neither the level
/// nor the start angle of a window matters. Windows are compared by Euclidean distance of these
/// rows. Throws Error(bad_input) for windows shorter than 256 samples.
BandPowers band_powers(const signal::WindowSet& windows);

inline constexpr Eigen::Index number_of_bands = 128;

}  // namespace piae::diagnosis

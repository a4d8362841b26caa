#pragma once

#include <Eigen/Core>

#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// A row for each window.
using BandPowers = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// [n, 128] the logarithm of each window's power in 128 bands of equal width under Hann's window,
/// without the bin of the offset, from which its mean over the bands is removed: neither the level
/// nor the angle at which a window starts counts. Windows are compared by Euclid's distance of
/// these. Throws Error(bad_input) for windows shorter than 256 samples.
BandPowers band_powers(const signal::WindowSet& windows);

inline constexpr Eigen::Index number_of_bands = 128;

}  // namespace piae::diagnosis

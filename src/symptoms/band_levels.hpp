#pragma once

#include <Eigen/Core>

#include "symptoms/bands.hpp"

namespace piae::symptoms {

/// The bands of a spectrum's shape.
inline constexpr Eigen::Index spectral_shape_bands = 48;

/// The mean power of one window in 48 bands of equal width between 1/60 and 59/60 of half the
/// sample rate (100 to 5900 Hz at 12 kHz), in dB, less its mean over the bands: the shape of the
/// spectrum, not how loud it is. The window is tapered by Hann's window. Throws Error(bad_input)
/// for a window so short (some 100 samples) that a band holds no frequency.
Eigen::ArrayXd spectral_shape_db(const Eigen::RowVectorXd& window);

/// The power of one window in each band of a bank by that of the whole window, in dB. The bank is
/// one for windows of this length.
Eigen::ArrayXd band_levels_db(const Eigen::RowVectorXd& window, const FilterBank& bank);

}  // namespace piae::symptoms

#pragma once

#include <Eigen/Core>
#include <array>

#include "spectra/bands.hpp"

namespace piae::trend {

inline constexpr std::size_t octaves = 6;

/// Returns six bands from 0 Hz to half the sample rate, ascending: the upper five are octaves. At
/// 25.6 kHz they are 0 to 400, 800, 1600, 3200, 6400 and 12800 Hz. Octaves resolve where a
/// structure is excited, and yet hold many bins of a window of 0.1 s, so that their levels scatter
/// by 1 to 2 dB.
std::array<spectra::Band, octaves> octave_bands(double rate_hz);

/// Returns the mean power of one window in each band, in dB. The window is tapered by Hann's
/// window, and its mean is removed. Throws Error(bad_input) for a window so short (below 128
/// samples) that a band has fewer than two bins.
Eigen::ArrayXd octave_levels_db(const Eigen::RowVectorXd& window);

}  // namespace piae::trend

#pragma once

#include <Eigen/Core>
#include <array>

#include "spectra/bands.hpp"

namespace piae::trend {

inline constexpr std::size_t octaves = 6;

/// Sample rate over the highest frequency that is watched. Recorders guarantee a spectrum without
/// aliases up to this share of their rate, and sensors are chosen for that. On PRONOSTIA the levels
/// above it, beyond 10 kHz, rise by 20 to 30 dB in the first hour of two bearings, one of which
/// then runs for two more hours.
inline constexpr double rate_over_bandwidth = 2.56;

/// Returns six bands from 0 Hz to the highest frequency that is watched, ascending: the upper five
/// are octaves. At 25.6 kHz they end at 312.5, 625, 1250, 2500, 5000 and 10000 Hz. Octaves resolve
/// where a structure is excited, and yet hold many bins of a window of 0.1 s, so that their levels
/// scatter by 1 to 2 dB.
std::array<spectra::Band, octaves> octave_bands(double rate_hz);

/// Returns the mean power of one window in each band, in dB. The window is tapered by Hann's
/// window, and its mean is removed. Throws Error(bad_input) for a window so short (below 256
/// samples) that a band has fewer than three bins.
Eigen::ArrayXd octave_levels_db(const Eigen::RowVectorXd& window);

}  // namespace piae::trend

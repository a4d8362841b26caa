#pragma once

#include "scoring/windows.hpp"

namespace piae::scoring {

/// Returns the root mean square error between generated window i and real window i (paper, eq. 28),
/// averaged over the pairs; in the unit of the recordings. Both functions on pairs throw
/// std::logic_error for sets of different shape and for sets without windows.
///
/// Interpret it with care: windows start at any angle of the shaft, so silence is nearer to real
/// windows than other real windows are (0.29 against 0.41 for CWRU's IR007).
double rmse(const Windows& generated, const Windows& real);

/// Returns the error after each generated window was circularly shifted to fit its real window best
/// (the shift with the largest cross-correlation, found by FFT).
double aligned_rmse(const Windows& generated, const Windows& real);

/// Returns the RMS of all generated windows divided by that of all real ones: 1 is right, 0 is
/// silence. Throws std::logic_error if the real windows are silent.
double amplitude_ratio(const Windows& generated, const Windows& real);

/// Returns the log-spectral distance (Gray and Markel 1976, the L2 norm) between the mean power
/// spectra P of two sets of windows, in dB: the root mean square over the bins 1 .. length / 2 of
/// 10 log10(P_generated / P_real). It depends on the frequencies and strengths of resonances, but
/// not on the phase of a window. Powers below 1e-10 of the real spectrum's mean are raised to it,
/// so that silence is far away, but finite. Throws std::logic_error if lengths differ or the real
/// windows are constant.
double spectral_distance_db(const Windows& generated, const Windows& real);

}  // namespace piae::scoring

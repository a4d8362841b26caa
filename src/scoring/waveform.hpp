#pragma once

#include "scoring/windows.hpp"

namespace piae::scoring {

/// Root mean square error between generated window i and real window i (paper, eq. 28), averaged
/// over the pairs; in the unit of the recordings. All functions here throw std::logic_error for
/// sets of different shape and for sets without windows.
///
/// Read it with care: windows start at any angle of the shaft, so silence is nearer to real windows
/// than other real windows are (0.29 against 0.41 for CWRU's IR007).
double rmse(const Windows& generated, const Windows& real);

/// The same after each generated window was shifted circularly so that it fits its real window best
/// (the shift with the largest cross-correlation, found by FFT).
double aligned_rmse(const Windows& generated, const Windows& real);

/// Root mean square of all generated windows divided by that of all real ones: 1 is right, 0 is
/// silence. Throws std::logic_error when the real windows are silent.
double amplitude_ratio(const Windows& generated, const Windows& real);

}  // namespace piae::scoring

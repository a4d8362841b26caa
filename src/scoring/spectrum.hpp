#pragma once

#include "scoring/windows.hpp"

namespace piae::scoring {

/// Hann's window in the periodic form, which is usual in spectral estimates.
Eigen::RowVectorXd hann(Eigen::Index length);

/// Mean power of each frequency bin 0 .. length / 2 over all windows. This is Welch's estimate
/// (1967) with the windows as its segments: the mean of each is removed, and it is tapered by
/// Hann's window. It is not scaled to a density, since only ratios are used. With `padding` above
/// 1, zeros are appended to that many times the length; the bins are then 0 .. padding * length /
/// 2, and closer.
Eigen::ArrayXd mean_power_spectrum(const Windows& windows, Eigen::Index padding = 1);

/// Log-spectral distance (Gray and Markel 1976, the L2 norm) between the mean power spectra P of
/// two sets of windows, in dB: the root mean square over the bins 1 .. length / 2 of 10
/// log10(P_generated / P_real). It sees which frequencies ring, and how strongly, but not the phase
/// of a window. Powers below 1e-10 of the real spectrum's mean are raised to it, so that silence is
/// far away but not infinitely far. Throws std::logic_error when lengths differ, and when the real
/// windows are constant.
double spectral_distance_db(const Windows& generated, const Windows& real);

}  // namespace piae::scoring

#pragma once

#include "scoring/windows.hpp"

namespace piae::scoring {

/// Mean power of each frequency bin 0 .. length / 2 over all windows: Welch's estimate (1967) with
/// the windows as its segments, each freed of its mean and tapered by Hann's window. Not scaled to
/// a density: only ratios are used. With zeros appended to `padding` times the length, bins lie
/// that much closer, 0 .. padding * length / 2.
Eigen::ArrayXd mean_power_spectrum(const Windows& windows, Eigen::Index padding = 1);

/// Log-spectral distance (Gray and Markel 1976, the L2 norm) between the mean power spectra P of
/// two sets of windows, in dB: the root mean square over the bins 1 .. length / 2 of 10
/// log10(P_generated / P_real). It sees which frequencies ring, and how strongly, but not the phase
/// of a window. Powers below 1e-10 of the real spectrum's mean count as that much, so that silence
/// is far away but not infinitely far. Throws std::logic_error when lengths differ, and when the
/// real windows hold nothing but a mean.
double spectral_distance_db(const Windows& generated, const Windows& real);

}  // namespace piae::scoring

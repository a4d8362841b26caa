#pragma once

#include <Eigen/Core>

#include "scoring/windows.hpp"

namespace piae::diagnosis {

/// Least amplitude as a part of the window's RMS; smaller ones are raised to it, so that a silent
/// band is far away, but finite.
inline constexpr double amplitude_floor = 1e-5;

/// Returns the root mean square of a window about its mean, in the unit of the recordings.
double root_mean_square(const scoring::Windows& window);

/// Returns the natural logarithm of the amplitude spectrum of one window, a row of N samples. The
/// window's mean is removed; the window is tapered by Hann's window and padded with zeros to the
/// least multiple of its length that gives at least `least_bands` bands (spectra/power.hpp). The
/// bands are the frequencies i / (padding * N) of the sample rate, i = 1 .. padding * N / 2;
/// frequency 0 is not a vibration. A sine of amplitude a gives ln(a) at its frequency: the
/// amplitude is
/// X
///  * 4 / N, since Hann's window has the mean 1/2 and half of a sine's amplitude lies at the
///  negative frequency (Harris 1978). Amplitudes below `floor`, in the unit of the recordings and
///  above 0, are raised to it.
Eigen::ArrayXd log_spectrum(const scoring::Windows& window, Eigen::Index least_bands, double floor);

/// Returns the log_spectrum() of the Hilbert envelope of one window, a row of N samples, over the
/// whole band (spectra/power.hpp; Smith and Randall 2015, method 1). A carrier of amplitude a with
/// the modulation 1 + m cos(2 pi f t) gives ln(a m) at f. Amplitudes below `floor` are raised to
/// it.
Eigen::ArrayXd log_envelope_spectrum(const scoring::Windows& window, Eigen::Index least_bands,
                                     double floor);

}  // namespace piae::diagnosis

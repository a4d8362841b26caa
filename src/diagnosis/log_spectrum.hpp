#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "scoring/windows.hpp"
#include "signal/window_set.hpp"

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
/// amplitude is X * 4 / N, since Hann's window has the mean 1/2 and half of a sine's amplitude lies
/// at the negative frequency (Harris 1978). Amplitudes below `floor`, in the unit of the recordings
/// and above 0, are raised to it.
Eigen::ArrayXd log_spectrum(const scoring::Windows& window, Eigen::Index least_bands, double floor);

/// Returns the log_spectrum() of the Hilbert envelope of one window, a row of N samples, over the
/// whole band (spectra/power.hpp; Smith and Randall 2015, method 1). A carrier of amplitude a with
/// the modulation 1 + m cos(2 pi f t) gives ln(a m) at f. Amplitudes below `floor` are raised to
/// it.
Eigen::ArrayXd log_envelope_spectrum(const scoring::Windows& window, Eigen::Index least_bands,
                                     double floor);

/// Returns the turns that the shaft makes in a window, at the window's own speed.
double shaft_turns(const signal::WindowSet& windows, std::size_t i);

/// Lowest and highest order of log_order_spectrum(). Three harmonics of each race's line lie
/// between them: of a 6205 up to 16.2.
inline constexpr double lowest_order = 0.5;
inline constexpr double highest_order = 20;

/// Returns log_envelope_spectrum() at `orders` multiples of the shaft frequency, equally spaced
/// from the lowest to the highest order; the shaft makes `turns` turns in the window. Interpolates
/// linearly between numbers half a cycle per window apart. Orders that the spectrum lacks, below
/// one cycle per window or above half the sample rate, get the mean of the others: so they cannot
/// make windows of two speeds different. If it lacks all, all are the logarithm of the floor.
Eigen::ArrayXd log_order_spectrum(const scoring::Windows& window, double turns, Eigen::Index orders,
                                  double floor);

}  // namespace piae::diagnosis

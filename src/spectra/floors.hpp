#pragma once

#include <Eigen/Core>
#include <vector>

namespace piae::spectra {

/// The value in the middle; of an even number of values the upper of the two in the middle. There
/// must be at least one value.
double median(std::vector<double> values);

/// The median of each number and of those near it, `width` in all, an odd number. Beyond either end
/// the array goes on as its mirror image, the last number twice. It must hold at least `width` / 2
/// numbers.
Eigen::ArrayXd running_median(const Eigen::ArrayXd& values, Eigen::Index width);

/// How wide the power is smoothed by which a window is whitened: wide against the lines of a shaft,
/// narrow against a resonance.
inline constexpr double smoothing_hz = 150;

/// The mean of each number and of those near it, weighted by Hann's window over `width` numbers, an
/// odd number of at least 3. Beyond either end the array goes on as its mirror image. It must hold
/// more than `width` / 2 numbers.
Eigen::ArrayXd smoothed(const Eigen::ArrayXd& values, Eigen::Index width);

/// The spectrum of one window of N samples at the bins 0 .. N / 2, each divided by the root of the
/// window's own power as smoothed over `smoothing_hz`. All frequencies are then about equally loud,
/// so that neither the transmission path nor a loud resonance decides what the envelope shows
/// (prewhitening: Randall and Antoni 2011, section 4). Bins that are quieter than 1e-9 of the
/// loudest amplitude are divided by that instead.
Eigen::ArrayXcd whitened_spectrum(const Eigen::RowVectorXd& window, double rate_hz);

}  // namespace piae::spectra

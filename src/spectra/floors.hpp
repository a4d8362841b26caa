#pragma once

#include <Eigen/Core>
#include <vector>

namespace piae::spectra {

/// Returns the median; for an even number of values, the upper of the two middle values. Needs at
/// least one value.
double median(std::vector<double> values);

/// Returns the running median over `width` numbers (odd). Beyond either end the array continues as
/// its mirror image, the last number twice. The array must hold at least `width` / 2 numbers.
Eigen::ArrayXd running_median(const Eigen::ArrayXd& values, Eigen::Index width);

/// Width over which whitening smooths the power: wide compared with the lines of a shaft, narrow
/// compared with a resonance.
inline constexpr double smoothing_hz = 150;

/// Returns the running mean weighted by Hann's window over `width` numbers (odd, at least 3).
/// Beyond either end the array continues as its mirror image. The array must hold more than `width`
/// / 2 numbers.
Eigen::ArrayXd smoothed(const Eigen::ArrayXd& values, Eigen::Index width);

/// Returns the spectrum of one window of N samples at the bins 0 .. N / 2, divided by the root of
/// the window's own power, smoothed over `smoothing_hz`. All frequencies then have about the same
/// level, so neither the transmission path nor a strong resonance dominates the envelope
/// (prewhitening: Randall and Antoni 2011, section 4). The divisor is at least 1e-9 of the largest
/// amplitude.
Eigen::ArrayXcd whitened_spectrum(const Eigen::RowVectorXd& window, double rate_hz);

}  // namespace piae::spectra

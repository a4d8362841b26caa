#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::impacts {

/// Spectra here have the bins 0 .. frame / 2 of a frame of an even number of samples.

/// A logarithmic spectrum without what changes faster along the frequency than with `quefrency`
/// samples, such as the lines of a lower impact rate. The cepstrum falls off in a straight line
/// over the last three tenths of that.
Eigen::ArrayXd liftered(const Eigen::ArrayXd& log_amplitude, double quefrency);

/// The response of minimum phase that has this amplitude (Oppenheim and Schafer 1989, Section
/// 12.7): the one that follows an impact soonest.
Eigen::ArrayXcd minimum_phase(const Eigen::ArrayXd& log_amplitude);

/// The real samples of a frame that has this spectrum.
Eigen::ArrayXd samples_of(const Eigen::ArrayXcd& spectrum);

/// Multiplies the spectrum of a window by gains at its bins 0 .. length / 2. What leaves at its end
/// comes in at its beginning. Throws std::logic_error for another number of gains.
void filter(std::span<double> window, std::span<const std::complex<double>> gains);

/// Indices of the windows of a condition. Those that belong to every condition count in each.
std::vector<std::size_t> windows_in(const signal::WindowSet& windows, std::int32_t condition);

/// Natural logarithm of the amplitude of some windows, at the bins 0 .. length of a frame of two
/// windows (of one sample more, if the length is odd): Welch's mean, of pieces of half a window
/// that overlap by three quarters.
Eigen::ArrayXd log_amplitude(const signal::WindowSet& windows, std::span<const std::size_t> own);

}  // namespace piae::impacts

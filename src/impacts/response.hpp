#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::impacts {

/// Spectra here have the bins 0 .. frame / 2 of a frame of an even number of samples.

/// Returns a logarithmic spectrum without changes along the frequency that are faster than
/// `quefrency` samples, such as the lines of a slow impact rate. The cepstrum falls off linearly
/// over the last three tenths of `quefrency`.
Eigen::ArrayXd liftered(const Eigen::ArrayXd& log_amplitude, double quefrency);

/// Returns the minimum-phase response with this amplitude (Oppenheim and Schafer 1989, Section
/// 12.7): the response that follows an impact soonest.
Eigen::ArrayXcd minimum_phase(const Eigen::ArrayXd& log_amplitude);

/// Returns the real samples of the frame that has this spectrum.
Eigen::ArrayXd samples_of(const Eigen::ArrayXcd& spectrum);

/// Multiplies the spectrum of a window by gains at its bins 0 .. length / 2. The filter is
/// circular: its tail wraps to the beginning. Throws std::logic_error if the number of gains is
/// wrong.
void filter(std::span<double> window, std::span<const std::complex<double>> gains);

/// Returns the indices of the windows of a condition, including windows that belong to every
/// condition.
std::vector<std::size_t> windows_in(const signal::WindowSet& windows, std::int32_t condition);

/// Returns the natural logarithm of the amplitude of some windows, at the bins 0 .. length of a
/// frame of two windows (one sample longer per window if the length is odd). Uses Welch's mean over
/// pieces of half a window that overlap by three quarters.
Eigen::ArrayXd log_amplitude(const signal::WindowSet& windows, std::span<const std::size_t> own);

}  // namespace piae::impacts

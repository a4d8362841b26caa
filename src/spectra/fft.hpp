#pragma once

#include <complex>
#include <span>

namespace piae::spectra {

/// Discrete Fourier transforms, X(k) = sum over n of x(n) exp(-2 pi i k n / N); the inverse divides
/// by N. For N real samples only the bins 0 to N/2 (rounded down) are stored, since the others
/// mirror them. Each thread keeps its plans, one per length. All functions throw std::logic_error
/// if the lengths do not fit, or if there are fewer than two samples.
///
/// Each kind of transform has a file of its own. Eigen's header takes 8 s to compile, and its code
/// depends, down to the last bits of the results, on the transforms that a file uses.
void fft(std::span<const double> samples, std::span<std::complex<double>> half_spectrum);
void fft(std::span<const float> samples, std::span<std::complex<float>> half_spectrum);
void fft(std::span<const std::complex<double>> samples, std::span<std::complex<double>> spectrum);

void inverse_fft(std::span<const std::complex<double>> half_spectrum, std::span<double> samples);
void inverse_fft(std::span<const std::complex<float>> half_spectrum, std::span<float> samples);
void inverse_fft(std::span<const std::complex<double>> spectrum,
                 std::span<std::complex<double>> samples);

}  // namespace piae::spectra

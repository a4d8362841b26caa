#pragma once

#include <complex>
#include <span>

namespace piae::spectra {

/// Discrete Fourier transforms, X(k) = sum over n of x(n) exp(-2 pi i k n / N); the inverse divides
/// by N. Of N real samples the bins 0 to N/2 (rounded down) are given and taken: the others mirror
/// them. Each thread keeps its plans, one for each length. All throw std::logic_error when the
/// lengths do not fit, or there are fewer than two samples.
///
/// The transforms are Eigen's. Its header takes 8 s to compile, and what the compiler makes of it
/// depends on which transforms a file asks for, down to the last bits of the results. So each kind
/// has a file of its own.
void fft(std::span<const double> samples, std::span<std::complex<double>> half_spectrum);
void fft(std::span<const float> samples, std::span<std::complex<float>> half_spectrum);
void fft(std::span<const std::complex<double>> samples, std::span<std::complex<double>> spectrum);

void inverse_fft(std::span<const std::complex<double>> half_spectrum, std::span<double> samples);
void inverse_fft(std::span<const std::complex<float>> half_spectrum, std::span<float> samples);
void inverse_fft(std::span<const std::complex<double>> spectrum,
                 std::span<std::complex<double>> samples);

}  // namespace piae::spectra

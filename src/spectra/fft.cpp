#include "spectra/fft.hpp"

#include <unsupported/Eigen/FFT>

#include "spectra/lengths.hpp"

namespace piae::spectra {

namespace {

using Complex = std::complex<double>;
using Plans = Eigen::FFT<double>;

Plans& real_plans() {
  thread_local Plans plans(Plans::impl_type(), Plans::HalfSpectrum);
  return plans;
}

}  // namespace

void fft(std::span<const double> samples, std::span<Complex> half_spectrum) {
  const auto length = real_length(samples.size(), half_spectrum.size());
  real_plans().fwd(half_spectrum.data(), samples.data(), length);
}

void inverse_fft(std::span<const Complex> half_spectrum, std::span<double> samples) {
  const auto length = real_length(samples.size(), half_spectrum.size());
  real_plans().inv(samples.data(), half_spectrum.data(), length);
}

}  // namespace piae::spectra

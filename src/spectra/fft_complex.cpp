#include <unsupported/Eigen/FFT>

#include "spectra/fft.hpp"
#include "spectra/lengths.hpp"

namespace piae::spectra {

namespace {

using Complex = std::complex<double>;
using Plans = Eigen::FFT<double>;

Plans& complex_plans() {
  thread_local Plans plans(Plans::impl_type(), Plans::HalfSpectrum);
  return plans;
}

}  // namespace

void fft(std::span<const Complex> samples, std::span<Complex> spectrum) {
  const auto length = length_of(samples.size(), spectrum.size(), samples.size());
  complex_plans().fwd(spectrum.data(), samples.data(), length);
}

void inverse_fft(std::span<const Complex> spectrum, std::span<Complex> samples) {
  const auto length = length_of(samples.size(), spectrum.size(), samples.size());
  complex_plans().inv(samples.data(), spectrum.data(), length);
}

}  // namespace piae::spectra

#include <unsupported/Eigen/FFT>

#include "spectra/fft.hpp"
#include "spectra/lengths.hpp"

namespace piae::spectra {

namespace {

using Complex = std::complex<float>;
using Plans = Eigen::FFT<float>;

Plans& single_plans() {
  thread_local Plans plans(Plans::impl_type(), Plans::HalfSpectrum);
  return plans;
}

}  // namespace

void fft(std::span<const float> samples, std::span<Complex> half_spectrum) {
  const auto length = real_length(samples.size(), half_spectrum.size());
  single_plans().fwd(half_spectrum.data(), samples.data(), length);
}

void inverse_fft(std::span<const Complex> half_spectrum, std::span<float> samples) {
  const auto length = real_length(samples.size(), half_spectrum.size());
  single_plans().inv(samples.data(), half_spectrum.data(), length);
}

}  // namespace piae::spectra

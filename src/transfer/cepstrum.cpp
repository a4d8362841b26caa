#include "transfer/cepstrum.hpp"

#include <algorithm>
#include <complex>

#include "spectra/fft.hpp"

namespace piae::transfer {

namespace {

using Eigen::ArrayXcd;
using Eigen::ArrayXd;
using Eigen::Index;

constexpr double fall_part = 0.3;

ArrayXcd spectrum_of(const ArrayXd& samples) {
  ArrayXcd spectrum(samples.size() / 2 + 1);
  spectra::fft({samples.data(), samples.data() + samples.size()},
               {spectrum.data(), spectrum.data() + spectrum.size()});
  return spectrum;
}

}  // namespace

ArrayXd samples_of(const ArrayXcd& spectrum) {
  ArrayXd samples(2 * (spectrum.size() - 1));
  spectra::inverse_fft({spectrum.data(), spectrum.data() + spectrum.size()},
                       {samples.data(), samples.data() + samples.size()});
  return samples;
}

ArrayXd liftered(const ArrayXd& log_amplitude, double quefrency) {
  ArrayXd cepstrum = samples_of(log_amplitude.cast<std::complex<double>>());
  for (Index i = 0; i < cepstrum.size(); ++i) {
    const auto place = static_cast<double>(std::min(i, cepstrum.size() - i));
    cepstrum[i] *= std::clamp((quefrency - place) / (fall_part * quefrency), 0.0, 1.0);
  }
  return spectrum_of(cepstrum).real();
}

ArrayXcd minimum_phase(const ArrayXd& log_amplitude) {
  ArrayXd cepstrum = samples_of(log_amplitude.cast<std::complex<double>>());
  const Index half = cepstrum.size() / 2;
  cepstrum.segment(1, half - 1) *= 2;
  cepstrum.tail(half - 1) = 0;
  return spectrum_of(cepstrum).exp();
}

}  // namespace piae::transfer

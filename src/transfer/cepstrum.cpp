#include "transfer/cepstrum.hpp"

#include <algorithm>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace piae::transfer {

namespace {

using Eigen::ArrayXcd;
using Eigen::ArrayXd;
using Eigen::Index;

constexpr double fall_part = 0.3;

Eigen::FFT<double> half_spectra() {
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  return fft;
}

ArrayXcd spectrum_of(const ArrayXd& samples) {
  Eigen::VectorXcd spectrum;
  half_spectra().fwd(spectrum, Eigen::VectorXd(samples));
  return spectrum.array();
}

}  // namespace

ArrayXd samples_of(const ArrayXcd& spectrum) {
  Eigen::VectorXd samples;
  half_spectra().inv(samples, Eigen::VectorXcd(spectrum), 2 * (spectrum.size() - 1));
  return samples.array();
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

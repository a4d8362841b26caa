#include "spectra/whole_band_envelope.hpp"

#include <complex>
#include <span>
#include <vector>

#include "spectra/fft.hpp"
#include "spectra/floors.hpp"

namespace piae::spectra {

Eigen::RowVectorXd whole_band_envelope(const Eigen::RowVectorXd& signal, double rate_hz) {
  const Eigen::ArrayXcd whitened = whitened_spectrum(signal, rate_hz);
  std::vector<std::complex<double>> spectrum(static_cast<std::size_t>(signal.size()));
  std::vector<std::complex<double>> analytic(spectrum.size());
  Eigen::Map<Eigen::ArrayXcd>(spectrum.data(), whitened.size()) = 2 * whitened;
  spectrum.front() = 0;
  inverse_fft(std::span<const std::complex<double>>(spectrum),
              std::span<std::complex<double>>(analytic));
  return Eigen::Map<const Eigen::RowVectorXcd>(analytic.data(), signal.size()).cwiseAbs2();
}

}  // namespace piae::spectra

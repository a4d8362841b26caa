#include "trend/low_pass.hpp"

#include <cmath>
#include <complex>
#include <span>
#include <vector>

#include "spectra/fft.hpp"
#include "trend/octave_bands.hpp"

namespace piae::trend {

Eigen::RowVectorXd low_passed(const Eigen::RowVectorXd& window) {
  Eigen::RowVectorXd passed = window;
  const auto length = static_cast<std::size_t>(window.size());
  std::vector<std::complex<double>> spectrum(length / 2 + 1);
  const std::span samples(passed.data(), length);
  spectra::fft(samples, spectrum);
  spectrum.front() = 0;
  const auto first =
      static_cast<std::size_t>(std::ceil(static_cast<double>(window.size()) / rate_over_bandwidth));
  for (std::size_t bin = first; bin < spectrum.size(); ++bin) spectrum[bin] = 0;
  spectra::inverse_fft(spectrum, samples);
  return passed;
}

}  // namespace piae::trend

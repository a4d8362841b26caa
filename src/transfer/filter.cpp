#include "transfer/filter.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>
#include <vector>

#include "spectra/fft.hpp"

namespace piae::transfer {

void filter(std::span<double> window, std::span<const std::complex<double>> gains) {
  if (gains.size() != window.size() / 2 + 1) {
    throw std::logic_error("filter: one gain for each bin of the spectrum");
  }
  std::vector<double> samples(window.begin(), window.end());
  std::vector<std::complex<double>> spectrum(gains.size());
  spectra::fft(samples, spectrum);
  for (std::size_t i = 0; i < gains.size(); ++i) spectrum[i] *= gains[i];
  spectra::inverse_fft(spectrum, samples);
  std::ranges::copy(samples, window.begin());
}

}  // namespace piae::transfer

#include "transfer/filter.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace piae::transfer {

void filter(std::span<double> window, std::span<const std::complex<double>> gains) {
  if (gains.size() != window.size() / 2 + 1) {
    throw std::logic_error("filter: one gain for each bin of the spectrum");
  }
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<double> samples(window.begin(), window.end());
  std::vector<std::complex<double>> spectrum;
  fft.fwd(spectrum, samples);
  for (std::size_t i = 0; i < gains.size(); ++i) spectrum[i] *= gains[i];
  fft.inv(samples, spectrum, static_cast<Eigen::Index>(samples.size()));
  std::ranges::copy(samples, window.begin());
}

}  // namespace piae::transfer

#include "phase/features.hpp"

#include <Eigen/Core>
#include <complex>

#include "signal/amplitude.hpp"
#include "spectra/fft.hpp"

namespace piae::phase {

std::vector<float> autocorrelation(std::span<const float> window) {
  const auto samples = static_cast<Eigen::Index>(window.size());
  // The transform is circular: without zero padding, the window's end would meet its beginning.
  Eigen::VectorXf padded = Eigen::VectorXf::Zero(samples + static_cast<Eigen::Index>(feature_lags));
  const Eigen::Map<const Eigen::VectorXf> values(window.data(), samples);
  // Do not use Eigen's mean(): its order of addition depends on the window's memory address.
  padded.head(samples) = values.array() - static_cast<float>(signal::mean_of(window));
  Eigen::VectorXcf spectrum(padded.size() / 2 + 1);
  const std::span bins(spectrum.data(), spectrum.data() + spectrum.size());
  spectra::fft({padded.data(), padded.data() + padded.size()}, bins);
  spectrum = spectrum.cwiseAbs2().cast<std::complex<float>>();
  Eigen::VectorXf lags(padded.size());
  spectra::inverse_fft(bins, {lags.data(), lags.data() + lags.size()});
  std::vector<float> features(feature_lags);
  for (std::size_t i = 0; i < feature_lags; ++i) {
    features[i] = lags[static_cast<Eigen::Index>(i) + 1] / lags[0];
  }
  return features;
}

}  // namespace piae::phase

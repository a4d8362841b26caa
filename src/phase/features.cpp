#include "phase/features.hpp"

#include <Eigen/Core>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "signal/amplitude.hpp"

namespace piae::phase {

std::vector<float> autocorrelation(std::span<const float> window) {
  const auto samples = static_cast<Eigen::Index>(window.size());
  // The transform is cyclic: without zeros behind the window, its end would meet its beginning.
  Eigen::VectorXf padded = Eigen::VectorXf::Zero(samples + static_cast<Eigen::Index>(feature_lags));
  const Eigen::Map<const Eigen::VectorXf> values(window.data(), samples);
  // Eigen's own mean() would add in an order that depends on where the window lies in memory.
  padded.head(samples) = values.array() - static_cast<float>(signal::mean_of(window));
  Eigen::FFT<float> fft;
  Eigen::VectorXcf spectrum;
  fft.fwd(spectrum, padded);
  spectrum = spectrum.cwiseAbs2().cast<std::complex<float>>();
  Eigen::VectorXf lags;
  fft.inv(lags, spectrum);
  std::vector<float> features(feature_lags);
  for (std::size_t i = 0; i < feature_lags; ++i) {
    features[i] = lags[static_cast<Eigen::Index>(i) + 1] / lags[0];
  }
  return features;
}

}  // namespace piae::phase

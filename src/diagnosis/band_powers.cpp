#include "diagnosis/band_powers.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <complex>
#include <vector>

#include "base/error.hpp"
#include "scoring/spectrum.hpp"
#include "spectra/fft.hpp"

namespace piae::diagnosis {

using Eigen::Index;

BandPowers band_powers(const signal::WindowSet& windows) {
  const auto length = static_cast<Index>(windows.length);
  if (length < 2 * number_of_bands) {
    throw Error(Exit::bad_input,
                fmt::format("windows of {} samples: {} bands need {} samples or more",
                            windows.length, number_of_bands, 2 * number_of_bands));
  }
  const Index bins = length / 2;
  const Eigen::RowVectorXd taper = scoring::hann(length);
  std::vector<double> tapered(windows.length);
  std::vector<std::complex<double>> spectrum(windows.length / 2 + 1);
  Eigen::ArrayXd power(bins);
  BandPowers features(static_cast<Index>(windows.size()), number_of_bands);
  for (Index i = 0; i < features.rows(); ++i) {
    const auto samples = windows.window(static_cast<std::size_t>(i));
    const Eigen::RowVectorXd window =
        Eigen::Map<const Eigen::RowVectorXf>(samples.data(), length).cast<double>();
    Eigen::Map<Eigen::RowVectorXd>(tapered.data(), length) =
        (window.array() - window.mean()) * taper.array();
    spectra::fft(tapered, spectrum);
    for (Index bin = 0; bin < bins; ++bin) {
      power[bin] = std::norm(spectrum[static_cast<std::size_t>(bin + 1)]);
    }
    const double floor = 1e-12 * power.mean() + 1e-300;  // silence is far away, not infinitely far
    for (Index band = 0; band < number_of_bands; ++band) {
      const Index from = band * bins / number_of_bands;
      const Index count = (band + 1) * bins / number_of_bands - from;
      features(i, band) = std::log(power.segment(from, count).mean() + floor);
    }
    features.row(i).array() -= features.row(i).mean();
  }
  return features;
}

}  // namespace piae::diagnosis

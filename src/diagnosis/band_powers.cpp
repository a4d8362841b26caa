#include "diagnosis/band_powers.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "spectra/bands.hpp"
#include "spectra/power.hpp"

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
  std::vector<Index> edges;
  for (Index band = 0; band <= number_of_bands; ++band) {
    edges.push_back(band * bins / number_of_bands);
  }
  BandPowers features(static_cast<Index>(windows.size()), number_of_bands);
  for (Index i = 0; i < features.rows(); ++i) {
    const auto samples = windows.window(static_cast<std::size_t>(i));
    const spectra::Windows window =
        Eigen::Map<const Eigen::RowVectorXf>(samples.data(), length).cast<double>();
    const Eigen::ArrayXd power = spectra::mean_power_spectrum(window).tail(bins);
    const double floor = 1e-12 * power.mean() + 1e-300;  // keeps silent bands far away, but finite
    features.row(i) = spectra::band_means(power, edges).unaryExpr([&](double mean) {
      return std::log(mean + floor);
    });
    features.row(i).array() -= features.row(i).mean();
  }
  return features;
}

}  // namespace piae::diagnosis

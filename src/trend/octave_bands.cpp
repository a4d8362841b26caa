#include "trend/octave_bands.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "spectra/power.hpp"

namespace piae::trend {

namespace {

constexpr Eigen::Index fewest_samples = 256;
constexpr double lowest_band = 1e-12;  // of the window's power: no level is -infinity

/// Returns the edges of the bands as fractions of the sample rate.
std::array<double, octaves + 1> edges() {
  std::array<double, octaves + 1> edges{};
  for (std::size_t i = 1; i <= octaves; ++i) {
    edges.at(i) =
        std::exp2(static_cast<double>(i) - static_cast<double>(octaves)) / rate_over_bandwidth;
  }
  return edges;
}

}  // namespace

std::array<spectra::Band, octaves> octave_bands(double rate_hz) {
  std::array<spectra::Band, octaves> bands;
  for (std::size_t i = 0; i < octaves; ++i) {
    bands.at(i) = {.low_hz = edges().at(i) * rate_hz, .high_hz = edges().at(i + 1) * rate_hz};
  }
  return bands;
}

Eigen::ArrayXd octave_levels_db(const Eigen::RowVectorXd& window) {
  if (window.size() < fewest_samples) {
    throw Error(Exit::bad_input,
                fmt::format("windows of {} samples are too short for levels in octaves; use {} or "
                            "more",
                            window.size(), fewest_samples));
  }
  const Eigen::ArrayXd power = spectra::mean_power_spectrum(window);
  const std::array<double, octaves + 1> shares = edges();
  std::vector<Eigen::Index> bins(shares.size());
  std::ranges::transform(shares, bins.begin(), [&](double share) {
    return static_cast<Eigen::Index>(std::ceil(share * static_cast<double>(window.size())));
  });
  const double floor = lowest_band * power.sum();
  return spectra::band_means(power, bins).unaryExpr([&](double mean) {
    return 10 * std::log10(mean + floor);
  });
}

}  // namespace piae::trend

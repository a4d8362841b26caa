#include "symptoms/band_levels.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "scoring/spectrum.hpp"
#include "symptoms/bands.hpp"

namespace piae::symptoms {

namespace {

using Eigen::Index;

constexpr double edge = 1.0 / 60;  // of half the sample rate, left out at both ends
// Parts of a window's power, to which what is less is raised: far away, not infinitely far.
constexpr double quietest_band = 1e-12;
constexpr double quietest_level = 1e-9;

/// The first bin at or above a band's lower edge.
Index first_bin(Index band, Index length) {
  const double share = edge + (1 - 2 * edge) * static_cast<double>(band) / spectral_shape_bands;
  return static_cast<Index>(std::ceil(share * static_cast<double>(length) / 2 - 1e-9));
}

}  // namespace

Eigen::ArrayXd spectral_shape_db(const Eigen::RowVectorXd& window) {
  const Eigen::ArrayXd power = scoring::mean_power_spectrum(window);
  const double floor = quietest_band * power.sum();
  Eigen::ArrayXd shape(spectral_shape_bands);
  for (Index band = 0; band < spectral_shape_bands; ++band) {
    const Index from = first_bin(band, window.size());
    const Index count = first_bin(band + 1, window.size()) - from;
    if (count == 0) {
      throw Error(Exit::bad_input,
                  fmt::format("windows of {} samples are too short for a spectrum in {} bands; "
                              "100 samples or more would do",
                              window.size(), spectral_shape_bands));
    }
    shape[band] = 10 * std::log10(power.segment(from, count).mean() + floor);
  }
  return shape - shape.mean();
}

Eigen::ArrayXd band_levels_db(const Eigen::RowVectorXd& window, const FilterBank& bank) {
  const Eigen::ArrayXd power = scoring::mean_power_spectrum(window);
  Eigen::ArrayXd levels(bank.responses.size());
  std::ranges::transform(bank.responses, levels.begin(), [&](const Eigen::ArrayXd& response) {
    const double passed = (power * response.square()).sum();
    return 10 * std::log10(passed / power.sum() + quietest_level);
  });
  return levels;
}

}  // namespace piae::symptoms

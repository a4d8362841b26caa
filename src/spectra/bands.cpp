#include "spectra/bands.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "spectra/power.hpp"

namespace piae::spectra {

namespace {

using Eigen::Index;

constexpr int most_bands = 9;
constexpr double first_hz = 300;
constexpr double width_hz = 1200;
constexpr double step_hz = 600;
constexpr double edge_hz = 100;

// Fractions of a window's power that are added as a floor, so that no level is -infinity.
constexpr double lowest_band = 1e-12;
constexpr double lowest_level = 1e-9;

/// Returns the first bin at or above a band's lower edge.
Index first_bin(Index band, Index length) {
  const double share =
      left_out_edge + (1 - 2 * left_out_edge) * static_cast<double>(band) / spectral_shape_bands;
  return static_cast<Index>(std::ceil(share * static_cast<double>(length) / 2 - 1e-9));
}

}  // namespace

std::vector<Band> narrow_bands(double rate_hz) {
  std::vector<Band> bands;
  for (int i = 0; i < most_bands; ++i) {
    const double low_hz = first_hz + i * step_hz;
    if (low_hz + width_hz / 2 <= rate_hz / 2) bands.push_back({low_hz, low_hz + width_hz});
  }
  return bands;
}

Eigen::ArrayXd response(const Band& band, Eigen::Index bins, double bin_hz) {
  const Eigen::ArrayXd hz =
      Eigen::ArrayXd::LinSpaced(bins, 0, bin_hz * static_cast<double>(bins - 1));
  const auto passed = [](const auto& beyond_edge_hz) {
    return (beyond_edge_hz / edge_hz + 0.5).max(0.0).min(1.0);
  };
  const Eigen::ArrayXd share = passed(hz - band.low_hz) * passed(band.high_hz - hz);
  return (std::numbers::pi / 2 * share).sin().square();
}

FilterBank filter_bank(double rate_hz, Eigen::Index length) {
  const double bin_hz = rate_hz / static_cast<double>(length);
  FilterBank bank{.rate_hz = rate_hz, .responses = {}};
  for (const Band& band : narrow_bands(rate_hz)) {
    bank.responses.push_back(response(band, length / 2 + 1, bin_hz));
  }
  return bank;
}

Eigen::ArrayXd band_means(const Eigen::ArrayXd& power, const std::vector<Index>& edges) {
  Eigen::ArrayXd means(edges.size() - 1);
  for (std::size_t band = 0; band + 1 < edges.size(); ++band) {
    means[static_cast<Index>(band)] =
        power.segment(edges[band], edges[band + 1] - edges[band]).mean();
  }
  return means;
}

Eigen::ArrayXd spectral_shape_db(const Eigen::RowVectorXd& window) {
  std::vector<Index> edges;
  for (Index band = 0; band <= spectral_shape_bands; ++band) {
    edges.push_back(first_bin(band, window.size()));
  }
  if (std::ranges::adjacent_find(edges) != edges.end()) {
    throw Error(Exit::bad_input,
                fmt::format("windows of {} samples are too short for a spectrum in {} bands; "
                            "use 100 samples or more",
                            window.size(), spectral_shape_bands));
  }
  const Eigen::ArrayXd power = mean_power_spectrum(window);
  const double floor = lowest_band * power.sum();
  const Eigen::ArrayXd shape = band_means(power, edges).unaryExpr([&](double mean) {
    return 10 * std::log10(mean + floor);
  });
  return shape - shape.mean();
}

Eigen::ArrayXd band_levels_db(const Eigen::RowVectorXd& window, const FilterBank& bank) {
  const Eigen::ArrayXd power = mean_power_spectrum(window);
  Eigen::ArrayXd levels(bank.responses.size());
  std::ranges::transform(bank.responses, levels.begin(), [&](const Eigen::ArrayXd& response) {
    const double passed = (power * response.square()).sum();
    return 10 * std::log10(passed / power.sum() + lowest_level);
  });
  return levels;
}

}  // namespace piae::spectra

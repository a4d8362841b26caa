#include "symptoms/bands.hpp"

#include <numbers>

namespace piae::symptoms {

namespace {

constexpr int most_bands = 9;
constexpr double first_hz = 300;
constexpr double width_hz = 1200;
constexpr double step_hz = 600;
constexpr double edge_hz = 100;

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

}  // namespace piae::symptoms

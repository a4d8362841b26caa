#include "trend/features.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "signal/dataset_info.hpp"
#include "spectra/lines.hpp"
#include "trend/low_pass.hpp"

namespace piae::trend {

namespace {

using Orders = std::array<double, symptoms::number_of_fault_types>;

constexpr double bins_apart = 2;  // half width of a line under Hann's window
constexpr double lowest_line = -1;

/// Returns the order that a spectrum must reach for all harmonics of these lines, with slip.
double last_order_of(const Orders& orders) {
  return symptoms::most_harmonics * (1 + spectra::largest_slip) * *std::ranges::max_element(orders);
}

double smallest_gap_of(Orders orders) {
  std::ranges::sort(orders);
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < orders.size(); ++i)
    gap = std::min(gap, orders.at(i) - orders.at(i - 1));
  return gap;
}

/// Returns a frequency with three or more digits.
std::string hertz(double hz) {
  constexpr double three_digits = 100;
  return hz < three_digits ? fmt::format("{:.3g}", hz) : fmt::format("{:.0f}", hz);
}

}  // namespace

std::optional<Lines> lines_shown(const bearing::Geometry& bearing, double speed_rpm, double rate_hz,
                                 std::size_t length) {
  const Lines lines{.orders = symptoms::line_orders(bearing), .speed_rpm = speed_rpm};
  const double shaft_hz = speed_rpm / 60;
  const double bins_between = symptoms::most_harmonics * smallest_gap_of(lines.orders) * shaft_hz *
                              static_cast<double>(length) / rate_hz;
  const bool is_below_half = last_order_of(lines.orders) * shaft_hz <= rate_hz / 2;
  const bool has_bands = !spectra::narrow_bands(rate_hz).empty();
  if (!is_below_half || !has_bands || bins_between < bins_apart) return std::nullopt;
  return lines;
}

FeatureMeter::FeatureMeter(double rate_hz, std::size_t length, const std::optional<Lines>& lines)
    : rate_hz_(rate_hz), length_(length), lines_(lines) {
  if (lines_) bank_ = spectra::filter_bank(rate_hz, static_cast<Eigen::Index>(length));
}

Features FeatureMeter::measure(std::span<const float> samples,
                               std::optional<double> speed_rpm) const {
  const Eigen::RowVectorXd window = Eigen::Map<const Eigen::RowVectorXf>(
                                        samples.data(), static_cast<Eigen::Index>(samples.size()))
                                        .cast<double>();
  const Eigen::RowVectorXd moving = low_passed(window);
  Features features;
  features.level_db = 10 * std::log10(moving.array().square().mean());
  features.shape_db = spectra::spectral_shape_db(window);
  features.watched_db.resize(static_cast<Eigen::Index>(names().size()));
  features.watched_db.head(octaves) = octave_levels_db(window);
  features.watched_db[octaves] = 20 * std::log10(moving.array().abs().maxCoeff());
  if (lines_) {
    features.watched_db.tail(lines_->orders.size()) =
        line_heights_db(window, speed_rpm.value_or(lines_->speed_rpm));
  }
  return features;
}

Eigen::ArrayXd FeatureMeter::line_heights_db(const Eigen::RowVectorXd& window,
                                             double speed_rpm) const {
  const spectra::OrderSpectrum spectrum =
      spectra::order_spectrum(window, bank_, speed_rpm / 60, last_order_of(lines_->orders));
  Eigen::ArrayXd heights_db(lines_->orders.size());
  std::ranges::transform(lines_->orders, heights_db.begin(), [&](double order) {
    return 10 * spectra::common_slip_height(spectrum, order, symptoms::most_harmonics, lowest_line);
  });
  return heights_db;
}

std::vector<std::string> FeatureMeter::names() const {
  std::vector<std::string> names;
  for (const spectra::Band& band : octave_bands(rate_hz_)) {
    names.push_back(hertz(band.low_hz) + "-" + hertz(band.high_hz) + " Hz");
  }
  names.emplace_back("peak");
  if (!lines_) return names;
  for (const bearing::Defect fault_type : symptoms::fault_types) {
    names.push_back(signal::to_string(fault_type) + " line");
  }
  return names;
}

}  // namespace piae::trend

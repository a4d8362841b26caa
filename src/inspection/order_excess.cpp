#include "inspection/order_excess.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "spectra/floors.hpp"
#include "spectra/lengths.hpp"
#include "spectra/mains.hpp"
#include "spectra/power.hpp"
#include "spectra/whole_band_envelope.hpp"

namespace piae::inspection {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

constexpr double order_step = 0.01;
constexpr double last_order = 70;
constexpr double floor_orders = 0.8;
constexpr std::size_t most_samples = std::size_t{1} << 19;
constexpr double highest_excess_db = 45;
constexpr Index healthy_reach = 2;  // steps within which a healthy line counts as the same line
constexpr Index line_reach = 1;     // steps within which a harmonic is searched
constexpr double foreign_reach = 0.03;
constexpr double shaft_reach = 0.01;  // of the order: twice or three times such a line shows, too
constexpr int side_band_harmonics = 6;
constexpr double mains_harmonics = 8;

/// Returns the highest value within `reach` steps of each.
ArrayXd highest_nearby(const ArrayXd& values, Index reach) {
  ArrayXd highest(values.size());
  for (Index i = 0; i < values.size(); ++i) {
    const Index first = std::max<Index>(0, i - reach);
    const Index last = std::min(values.size() - 1, i + reach);
    highest[i] = values.segment(first, last - first + 1).maxCoeff();
  }
  return highest;
}

/// Returns the highest power within each hundredth of an order; the nearest bin if none lies
/// within.
ArrayXd power_by_order(const ArrayXd& power, double bin_orders) {
  const double bins = order_step / bin_orders;
  const auto most = static_cast<Index>(static_cast<double>(power.size() - 2) / bins);
  ArrayXd cells(std::min<Index>(std::lround(last_order / order_step), most));
  for (Index i = 0; i < cells.size(); ++i) {
    const double middle = static_cast<double>(i) * bins;
    const auto first = std::max<Index>(0, static_cast<Index>(std::ceil(middle - bins / 2)));
    const auto end = static_cast<Index>(std::ceil(middle + bins / 2));
    cells[i] = end > first ? power.segment(first, end - first).maxCoeff()
                           : power[static_cast<Index>(std::lround(middle))];
  }
  return cells;
}

/// Distance of an order from the next multiple of `unit`.
double distance_from_multiple(double order, double unit) {
  return std::abs(order - unit * std::round(order / unit));
}

}  // namespace

ArrayXd order_lines_db(std::span<const double> signal, double rate_hz, double shaft_hz) {
  const std::size_t used = std::min(signal.size(), most_samples);
  if (static_cast<double>(used) / rate_hz * shaft_hz < fewest_turns_for_orders) return {};
  const auto samples = static_cast<Index>(spectra::fast_length(used));
  const Eigen::RowVectorXd start = Eigen::Map<const Eigen::RowVectorXd>(signal.data(), samples);
  if (start.maxCoeff() == start.minCoeff()) return {};
  const ArrayXd power =
      spectra::mean_power_spectrum(spectra::Windows(spectra::whole_band_envelope(start, rate_hz)));
  const double bin_orders = rate_hz / static_cast<double>(samples) / shaft_hz;
  const ArrayXd decibels =
      10 * (power_by_order(power, bin_orders) + std::numeric_limits<double>::min()).log10();
  constexpr auto floor_width = static_cast<Index>(floor_orders / order_step) / 2 * 2 + 1;
  if (decibels.size() < floor_width) return {};
  return decibels - spectra::running_median(decibels, floor_width);
}

OrderExcess::OrderExcess(const ArrayXd& suspect, const ArrayXd& healthy, double shaft_hz)
    : shaft_hz_(shaft_hz) {
  const Index size = std::min(suspect.size(), healthy.size());
  const ArrayXd known = highest_nearby(healthy.head(size), healthy_reach).max(0);
  excess_db_ =
      highest_nearby((suspect.head(size) - known).max(0).min(highest_excess_db), line_reach);
}

double OrderExcess::at(double order) const {
  const Index i = std::lround(std::abs(order) / order_step);
  return i < excess_db_.size() ? excess_db_[i] : 0;
}

bool OrderExcess::is_near_mains(double order) const {
  return std::ranges::any_of(spectra::mains_hz, [&](double hz) {
    const double unit = hz / shaft_hz_;
    const double harmonic = std::clamp(std::round(order / unit), 1.0, mains_harmonics);
    return std::abs(order - harmonic * unit) <= foreign_reach;
  });
}

bool OrderExcess::may_be_foreign(double order) const {
  return distance_from_multiple(order, 0.5) <= foreign_reach ||
         distance_from_multiple(order, 1) <= shaft_reach * order || is_near_mains(order);
}

std::optional<double> OrderExcess::comb_db(double order, int count, int step) const {
  double sum = 0;
  int tried = 0;
  int counted = 0;
  for (int h = 1; h <= count; h += step) {
    ++tried;
    const double place = h * order;
    const bool is_beyond = std::lround(place / order_step) >= excess_db_.size();
    const bool is_foreign =
        distance_from_multiple(place, 0.5) <= foreign_reach || is_near_mains(place);
    if (is_foreign && !is_beyond) continue;
    sum += at(place);
    ++counted;
  }
  if (2 * counted < tried) return std::nullopt;
  return sum / counted;
}

double OrderExcess::side_bands_db(double order, double distance) const {
  double sum = 0;
  for (int h = 1; h <= side_band_harmonics; ++h) {
    sum += at(h * order - distance) + at(h * order + distance);
  }
  return sum / (2 * side_band_harmonics);
}

}  // namespace piae::inspection

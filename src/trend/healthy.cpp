#include "trend/healthy.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "signal/ranges.hpp"
#include "symptoms/baseline.hpp"
#include "trend/octave_bands.hpp"

namespace piae::trend {

namespace {

using Eigen::Index;
using Row = Eigen::ArrayXd Features::*;

constexpr Range possible_db{.low = -1000, .high = 1000, .unit = " dB"};
constexpr Range window_samples{.low = 256, .high = 1 << 24, .unit = " samples"};

Eigen::ArrayXXd rows_of(const std::vector<Features>& windows, Row row) {
  Eigen::ArrayXXd rows(windows.size(), (windows.front().*row).size());
  for (std::size_t i = 0; i < windows.size(); ++i) {
    rows.row(static_cast<Index>(i)) = (windows[i].*row).transpose();
  }
  return rows;
}

const std::vector<Features>& require_enough(const std::vector<Features>& windows) {
  if (windows.size() >= symptoms::fewest_healthy) return windows;
  throw Error(Exit::bad_input,
              fmt::format("the healthy hours hold {} windows with a signal, but a baseline needs "
                          "{} or more; give more hours (--healthy)",
                          windows.size(), symptoms::fewest_healthy));
}

std::vector<double> flat(const std::vector<Features>& windows, Row row) {
  std::vector<double> values;
  for (const Features& window : windows) {
    values.insert(values.end(), (window.*row).begin(), (window.*row).end());
  }
  return values;
}

Eigen::ArrayXd row_of(const std::vector<double>& values, std::size_t i, std::size_t columns) {
  return Eigen::Map<const Eigen::ArrayXd>(values.data() + i * columns, static_cast<Index>(columns));
}

std::optional<Lines> read_lines(const artefact::Reader& reader) {
  if (!reader.has("/line_orders")) return std::nullopt;
  Lines lines;
  const auto orders = reader.numbers<double>("/line_orders", {lines.orders.size()}).values;
  reader.require_all("/line_orders", orders, signal::ranges::fault_order);
  std::ranges::copy(orders, lines.orders.begin());
  lines.speed_rpm = reader.real("/", "shaft_speed_rpm", signal::ranges::shaft_speed_rpm);
  return lines;
}

}  // namespace

Healthy::Healthy(std::vector<Features> windows, const TrendOptions& options)
    : windows_(std::move(windows)),
      novelty_(rows_of(require_enough(windows_), &Features::shape_db)) {
  const Eigen::ArrayXXd watched = rows_of(windows_, &Features::watched_db);
  const auto n = static_cast<double>(windows_.size());
  for (const Features& window : windows_) level_db_ += window.level_db / n;
  mean_db_ = watched.colwise().mean();
  const Eigen::ArrayXd deviation =
      ((watched.rowwise() - mean_db_.transpose()).square().colwise().sum() / (n - 1)).sqrt();
  limits_db_ = (options.spreads * deviation).max(options.least_rise_db);
}

void write(artefact::Writer& writer, const FeatureMeter& meter,
           const std::vector<Features>& windows) {
  writer.attribute("/", "sample_rate_hz", meter.rate_hz());
  writer.attribute("/", "window_samples", static_cast<std::int64_t>(meter.length()));
  const std::size_t n = windows.size();
  std::vector<double> levels(n);
  std::ranges::transform(windows, levels.begin(), &Features::level_db);
  writer.numbers("/level_db", levels);
  writer.numbers("/watched_db", flat(windows, &Features::watched_db), {n, meter.names().size()});
  writer.numbers("/shape_db", flat(windows, &Features::shape_db),
                 {n, std::size_t{spectra::spectral_shape_bands}});
  if (!meter.lines()) return;
  const auto& orders = meter.lines()->orders;
  writer.numbers("/line_orders", std::vector<double>(orders.begin(), orders.end()));
  writer.attribute("/", "shaft_speed_rpm", meter.lines()->speed_rpm);
}

Baseline read_baseline(const artefact::Reader& reader) {
  const double rate_hz = reader.real("/", "sample_rate_hz", signal::ranges::sample_rate_hz);
  const auto length =
      static_cast<std::size_t>(reader.integer("/", "window_samples", window_samples));
  Baseline baseline{.meter = FeatureMeter(rate_hz, length, read_lines(reader)), .windows = {}};
  const std::vector<double> levels = reader.numbers<double>("/level_db", {0}).values;
  const std::size_t n = levels.size();
  if (n < symptoms::fewest_healthy) {
    reader.refuse("/level_db", fmt::format("has {} healthy windows, but needs {} or more", n,
                                           symptoms::fewest_healthy));
  }
  const std::size_t watched = baseline.meter.names().size();
  constexpr std::size_t bands{spectra::spectral_shape_bands};
  const auto rises = reader.numbers<double>("/watched_db", {n, watched}).values;
  const auto shapes = reader.numbers<double>("/shape_db", {n, bands}).values;
  reader.require_all("/level_db", levels, possible_db);
  reader.require_all("/watched_db", rises, possible_db);
  reader.require_all("/shape_db", shapes, possible_db);
  for (std::size_t i = 0; i < n; ++i) {
    baseline.windows.push_back({.level_db = levels[i],
                                .watched_db = row_of(rises, i, watched),
                                .shape_db = row_of(shapes, i, bands)});
  }
  return baseline;
}

}  // namespace piae::trend

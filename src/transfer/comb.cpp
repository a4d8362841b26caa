#include "transfer/comb.hpp"

#include <algorithm>
#include <cmath>

#include "spectra/power.hpp"

namespace piae::transfer {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

constexpr double period_tolerance = 0.015;
constexpr int periods_tried = 13;
constexpr double places_in_a_period = 100;
constexpr double averaged_part = 1.0 / 14;

/// Returns the moving average over `width` samples around each; values beyond the ends count as 0.
ArrayXd averaged(const ArrayXd& values, Index width) {
  ArrayXd sums(values.size() + 1);
  sums[0] = 0;
  for (Index i = 0; i < values.size(); ++i) sums[i + 1] = sums[i] + values[i];
  ArrayXd means(values.size());
  for (Index i = 0; i < values.size(); ++i) {
    const Index from = std::max<Index>(0, i - width / 2);
    const Index to = std::min<Index>(values.size(), i - width / 2 + width);
    means[i] = (sums[to] - sums[from]) / static_cast<double>(width);
  }
  return means;
}

ArrayXd envelope_of(std::span<const double> window, double period) {
  const auto length = static_cast<Index>(window.size());
  const spectra::Windows row = Eigen::Map<const Eigen::RowVectorXd>(window.data(), length);
  const ArrayXd envelope = spectra::envelopes(row).row(0).transpose().array();
  return averaged(envelope, std::max<Index>(1, std::lround(averaged_part * period)));
}

int impacts_before(double end, const Comb& comb) {
  int count = 0;
  while (comb.first + count * comb.period < end) ++count;
  return count;
}

double mean_on(const Comb& comb, const ArrayXd& envelope) {
  const int impact_positions = impacts_before(static_cast<double>(envelope.size()), comb);
  double sum = 0;
  for (int i = 0; i < impact_positions; ++i) {
    sum += envelope[static_cast<Index>(comb.first + i * comb.period)];
  }
  return impact_positions > 0 ? sum / impact_positions : 0;
}

}  // namespace

std::vector<std::size_t> Comb::impact_positions(std::size_t length) const {
  std::vector<std::size_t> all;
  const int count = impacts_before(static_cast<double>(length), *this);
  all.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) all.push_back(static_cast<std::size_t>(first + i * period));
  return all;
}

Comb find_comb(std::span<const double> window, double nominal_period) {
  const ArrayXd envelope = envelope_of(window, nominal_period);
  Comb best;
  double highest = -1;
  for (int i = 0; i < periods_tried; ++i) {
    const double off = period_tolerance * (2.0 * i / (periods_tried - 1) - 1);
    const double period = nominal_period * (1 + off);
    const double step = std::max(1.0, period / places_in_a_period);
    const int places = static_cast<int>(std::ceil(period / step));
    for (int j = 0; j < places; ++j) {
      const Comb comb{.first = j * step, .period = period};
      const double height = mean_on(comb, envelope);
      if (height <= highest) continue;
      highest = height;
      best = comb;
    }
  }
  return best;
}

std::vector<double> seen_strengths(std::span<const double> window, const Comb& comb) {
  ArrayXd envelope = envelope_of(window, comb.period);
  ArrayXd sorted = envelope;
  std::sort(sorted.begin(), sorted.end());
  const double median = sorted[sorted.size() / 2];
  std::vector<double> all;
  double sum = 0;
  for (const std::size_t impact : comb.impact_positions(window.size())) {
    all.push_back(std::max(0.0, envelope[static_cast<Index>(impact)] - median));
    sum += all.back();
  }
  for (double& one : all) one = sum > 0 ? one * static_cast<double>(all.size()) / sum : 1;
  return all;
}

}  // namespace piae::transfer

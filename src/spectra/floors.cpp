#include "spectra/floors.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "spectra/fft.hpp"

namespace piae::spectra {

namespace {

using Eigen::Index;

constexpr double lowest = 1e-9;  // fraction of the largest amplitude: rounding

/// Replaces one number in a sorted array by another, and keeps the array sorted.
void replace(std::vector<double>& sorted, double old, double with) {
  const auto from = std::ranges::lower_bound(sorted, old);
  const auto to = std::ranges::lower_bound(sorted, with);
  if (from < to) {
    *std::move(from + 1, to, from) = with;
  } else {
    std::move_backward(to, from, from + 1);
    *to = with;
  }
}

/// Returns Hann's window without the zeros at its ends, normalised to the sum 1.
Eigen::ArrayXd hann_weights(Index width) {
  Eigen::ArrayXd weights(width);
  for (Index i = 0; i < width; ++i) {
    weights[i] = 1 - std::cos(2 * std::numbers::pi * static_cast<double>(i + 1) /
                              static_cast<double>(width + 1));
  }
  return weights / weights.sum();
}

/// Returns the values with `half` mirrored numbers added at both ends.
Eigen::ArrayXd mirrored(const Eigen::ArrayXd& values, Index half) {
  const Index n = values.size();
  Eigen::ArrayXd longer(n + 2 * half);
  longer << values.segment(1, half).reverse(), values, values.segment(n - 1 - half, half).reverse();
  return longer;
}

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Eigen::ArrayXd running_median(const Eigen::ArrayXd& values, Eigen::Index width) {
  const Eigen::Index half = width / 2;
  Eigen::ArrayXd longer(values.size() + 2 * half);
  longer << values.head(half).reverse(), values, values.tail(half).reverse();
  Eigen::ArrayXd medians(values.size());
  std::vector<double> sorted(longer.begin(), longer.begin() + width);
  std::ranges::sort(sorted);
  for (Eigen::Index i = 0; i < medians.size(); ++i) {
    medians[i] = sorted[static_cast<std::size_t>(half)];
    if (i + 1 < medians.size()) replace(sorted, longer[i], longer[i + width]);
  }
  return medians;
}

Eigen::ArrayXd smoothed(const Eigen::ArrayXd& values, Index width) {
  const Eigen::ArrayXd weights = hann_weights(width);
  const Eigen::ArrayXd longer = mirrored(values, width / 2);
  Eigen::ArrayXd means(values.size());
  for (Index i = 0; i < means.size(); ++i) means[i] = (longer.segment(i, width) * weights).sum();
  return means;
}

Eigen::ArrayXcd whitened_spectrum(const Eigen::RowVectorXd& window, double rate_hz) {
  std::vector<double> samples(static_cast<std::size_t>(window.size()));
  Eigen::Map<Eigen::RowVectorXd>(samples.data(), window.size()) = window.array() - window.mean();
  Eigen::ArrayXcd spectrum(window.size() / 2 + 1);
  fft(samples, {spectrum.data(), spectrum.data() + spectrum.size()});
  const auto bins = std::lround(smoothing_hz * static_cast<double>(window.size()) / rate_hz);
  const Index width = std::max<Index>(3, bins / 2 * 2 + 1);
  const Eigen::ArrayXd amplitude = smoothed(spectrum.abs2(), width).sqrt();
  const double floor = lowest * amplitude.maxCoeff() + std::numeric_limits<double>::min();
  return spectrum / amplitude.max(floor);
}

}  // namespace piae::spectra

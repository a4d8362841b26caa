#include "spectra/shaft_speed.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "spectra/floors.hpp"
#include "spectra/lengths.hpp"
#include "spectra/mains.hpp"
#include "spectra/power.hpp"
#include "spectra/whole_band_envelope.hpp"

namespace piae::spectra {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

constexpr double range = speed_search_percent / 100;
constexpr int harmonics = 20;  // of the signal
constexpr int envelope_harmonics = 8;
constexpr int fewest_harmonics = 3;
constexpr double fewest_turns = 20;
constexpr std::size_t most_samples = std::size_t{1} << 19;
constexpr double highest_db = 15;
constexpr double floor_width = 0.5;   // of the speed
constexpr double own_peak = 0.005;    // relative half width of a peak of the sum
constexpr double step_in_bins = 0.5;  // of the last harmonic

/// Candidate speeds of a search, in Hz.
ArrayXd candidates(double given_hz, double bin_hz) {
  const double step_hz = step_in_bins * bin_hz / harmonics;
  const auto steps = static_cast<Index>(range * given_hz / step_hz);
  return given_hz + step_hz * ArrayXd::LinSpaced(2 * steps + 1, -static_cast<double>(steps),
                                                 static_cast<double>(steps));
}

/// Returns the bins that `count` harmonics need, in dB above their running median, clipped.
ArrayXd lines_db(const ArrayXd& power, double bin_hz, double given_hz, double highest_hz) {
  const Index half = std::max<Index>(2, std::lround(floor_width * given_hz / bin_hz / 2));
  const Index needed = static_cast<Index>(std::ceil(highest_hz / bin_hz)) + half + 2;
  const ArrayXd decibels =
      10 *
      (power.head(std::min(needed, power.size())) + std::numeric_limits<double>::min()).log10();
  return (decibels - running_median(decibels, 2 * half + 1)).max(0).min(highest_db);
}

/// Returns how far the harmonics of one speed stand out: the mean of their lines, without the
/// multiples of that prime which leave the least.
double comb(const ArrayXd& lines, double harmonic_bins, int count) {
  constexpr std::array primes{2, 3, 5, 7, 11, 13};
  ArrayXd heights(count);
  for (int n = 1; n <= count; ++n) {
    const Index bin = std::lround(n * harmonic_bins);
    heights[n - 1] = lines[std::min(bin, lines.size() - 1)];
  }
  double least = heights.mean();
  for (const int prime : primes) {
    double sum = 0;
    int others = 0;
    for (int n = 1; n <= count; ++n) {
      if (n % prime == 0) continue;
      sum += heights[n - 1];
      ++others;
    }
    least = std::min(least, sum / others);
  }
  return least;
}

ArrayXd comb(const ArrayXd& lines, double bin_hz, const ArrayXd& speeds_hz, int count) {
  ArrayXd combs(speeds_hz.size());
  for (Index i = 0; i < combs.size(); ++i) combs[i] = comb(lines, speeds_hz[i] / bin_hz, count);
  return combs;
}

/// Returns the values minus their mean, over their standard deviation; zeros if all are equal.
ArrayXd standardised(const ArrayXd& values) {
  const ArrayXd about = values - values.mean();
  const double deviation = std::sqrt(about.square().mean());
  return deviation > 0 ? ArrayXd(about / deviation) : ArrayXd::Zero(values.size());
}

ArrayXd power_of(const Eigen::RowVectorXd& signal) { return mean_power_spectrum(Windows(signal)); }

/// True if all harmonics of this speed are those of the mains, too.
bool turns_with_the_mains(double speed_hz) {
  constexpr double reach = 0.002;
  return std::ranges::any_of(mains_hz,
                             [&](double mains) { return std::abs(speed_hz / mains - 1) < reach; });
}

/// Returns the best speed and its distance from the best of the others.
ShaftSpeed best_of(const ArrayXd& speeds_hz, const ArrayXd& sum) {
  Index best = 0;
  const double highest = sum.maxCoeff(&best);
  double other = sum.minCoeff();
  for (Index i = 0; i < sum.size(); ++i) {
    const bool is_apart = std::abs(speeds_hz[i] / speeds_hz[best] - 1) > own_peak;
    if (is_apart) other = std::max(other, sum[i]);
  }
  const double speed_hz = speeds_hz[best];
  return {.rpm = 60 * speed_hz, .confidence = turns_with_the_mains(speed_hz) ? 0 : highest - other};
}

}  // namespace

bool ShaftSpeed::is_within(double percent, double given_rpm) const {
  return is_certain() && std::abs(rpm / given_rpm - 1) <= percent / 100;
}

std::optional<ShaftSpeed> estimate_shaft_speed(std::span<const double> signal, double rate_hz,
                                               double given_rpm) {
  const double given_hz = given_rpm / 60;
  const auto count =
      static_cast<int>(std::min<double>(harmonics, rate_hz / 2 / (given_hz * (1 + range))));
  const double turns = static_cast<double>(signal.size()) / rate_hz * given_hz;
  if (turns < fewest_turns || count < fewest_harmonics) return std::nullopt;
  const auto samples = static_cast<Index>(fast_length(std::min(signal.size(), most_samples)));
  const Eigen::RowVectorXd start = Eigen::Map<const Eigen::RowVectorXd>(signal.data(), samples);
  if (start.maxCoeff() == start.minCoeff()) return std::nullopt;

  const double bin_hz = rate_hz / static_cast<double>(samples);
  const ArrayXd speeds_hz = candidates(given_hz, bin_hz);
  const auto combed = [&](const Eigen::RowVectorXd& of, int most) {
    const int used = std::min(most, count);
    const double highest_hz = used * given_hz * (1 + range);
    return standardised(
        comb(lines_db(power_of(of), bin_hz, given_hz, highest_hz), bin_hz, speeds_hz, used));
  };
  return best_of(speeds_hz, combed(start, harmonics) +
                                combed(whole_band_envelope(start, rate_hz), envelope_harmonics));
}

}  // namespace piae::spectra

#include "diagnosis/log_spectrum.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "spectra/bands.hpp"
#include "spectra/power.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

constexpr Index shortest_for_log_frequency = 256;
constexpr double lowest_cycles = 4;  // in a window

/// Numbers per cycle per window of a spectrum that has as many bands as the window samples.
constexpr double bands_of_a_cycle = 2;

/// Interpolates linearly between the numbers of such a spectrum, the first of which is half a
/// cycle.
double at_cycles(const ArrayXd& spectrum, double cycles) {
  const double place = bands_of_a_cycle * cycles - 1;
  const Index before = std::min(static_cast<Index>(place), spectrum.size() - 2);
  return std::lerp(spectrum[before], spectrum[before + 1], place - static_cast<double>(before));
}

}  // namespace

double root_mean_square(const scoring::Windows& window) {
  return std::sqrt((window.array() - window.mean()).square().mean());
}

Eigen::ArrayXd log_spectrum(const scoring::Windows& window, Eigen::Index least_bands,
                            double floor) {
  const Eigen::Index length = window.cols();
  Eigen::Index padding = 1;
  while (padding * length / 2 < least_bands) ++padding;
  const Eigen::ArrayXd power =
      spectra::mean_power_spectrum(window, padding).tail(padding * length / 2);
  return (4 / static_cast<double>(length) * power.sqrt()).max(floor).log();
}

Eigen::ArrayXd log_envelope_spectrum(const scoring::Windows& window, Eigen::Index least_bands,
                                     double floor) {
  return log_spectrum(spectra::envelopes(window), least_bands, floor);
}

Eigen::ArrayXd log_frequency_spectrum(const scoring::Windows& window, Eigen::Index bands,
                                      double floor) {
  const Index length = window.cols();
  if (length < shortest_for_log_frequency) {
    throw Error(Exit::bad_input,
                fmt::format("windows of {} samples: bands of log frequency need {} samples or more",
                            length, shortest_for_log_frequency));
  }
  const ArrayXd power = (2 * log_spectrum(window, length, floor)).exp();
  const ArrayXd cycles =
      ArrayXd::LinSpaced(bands + 1, std::log(lowest_cycles),
                         std::log(static_cast<double>(power.size()) / bands_of_a_cycle))
          .exp();
  // The first number is half a cycle and covers a quarter on either side.
  const ArrayXd edges = (bands_of_a_cycle * cycles - 0.5).min(static_cast<double>(power.size()));
  return spectra::fractional_band_means(power, edges).log() / 2;
}

Eigen::ArrayXd log_order_spectrum(const scoring::Windows& window, double turns, Eigen::Index orders,
                                  double floor) {
  const ArrayXd spectrum = log_envelope_spectrum(window, window.cols(), floor);
  const double highest_cycles = static_cast<double>(spectrum.size()) / bands_of_a_cycle;
  const ArrayXd cycles = turns * ArrayXd::LinSpaced(orders, lowest_order, highest_order);
  const auto has = (cycles >= 1 && cycles <= highest_cycles).eval();
  if (!has.any()) return ArrayXd::Constant(orders, std::log(floor));
  ArrayXd heights = ArrayXd::Zero(orders);
  for (Index i = 0; i < orders; ++i) {
    if (has[i]) heights[i] = at_cycles(spectrum, cycles[i]);
  }
  const double mean = heights.sum() / static_cast<double>(has.count());
  return has.select(heights, mean);
}

}  // namespace piae::diagnosis

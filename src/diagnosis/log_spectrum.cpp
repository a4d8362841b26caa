#include "diagnosis/log_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include "spectra/power.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

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

double shaft_turns(const signal::WindowSet& windows, std::size_t i) {
  const double duration_s = static_cast<double>(windows.length) / windows.info.sample_rate_hz;
  return windows.speed_rpm(i) / 60 * duration_s;
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

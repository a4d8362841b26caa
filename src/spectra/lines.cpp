#include "spectra/lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "spectra/floors.hpp"

namespace piae::spectra {

namespace {

constexpr Eigen::Index padding = 4;
constexpr double lobe_bins = 2;  // half of the main lobe of Hann's window, before padding
// The lobe of the third harmonic may reach this fraction of the distance to the next harmonic.
constexpr double largest_lobe = 0.25;
// Fraction of the windows' power below which a power is rounding alone.
constexpr double rounding_power = 1e-20;

constexpr int slip_steps = 12;  // steps in either direction
constexpr double slip_step = largest_slip / slip_steps;
constexpr double highest = 2.5;  // clips heights: a line this far up is clear

std::size_t bin_at(const EnvelopeSpectrum& spectrum, double hz) {
  return static_cast<std::size_t>(std::lround(hz / spectrum.bin_hz));
}

/// Returns half the width of a harmonic. The harmonic may lie anywhere within the tolerance and is
/// as wide as the main lobe of Hann's window. The floor begins outside of both.
double lobe_hz(const EnvelopeSpectrum& spectrum, int number, double line_hz) {
  return line_tolerance * (number * line_hz) + lobe_bins * spectrum.resolution_hz;
}

/// Returns the powers on both sides of a harmonic, half way to the next harmonics.
std::vector<double> powers_next_to(const EnvelopeSpectrum& spectrum, int number, double line_hz) {
  const double hz = number * line_hz;
  const double lobe = lobe_hz(spectrum, number, line_hz);
  std::vector<double> powers;
  const std::size_t last = bin_at(spectrum, hz + line_hz / 2);
  for (std::size_t i = bin_at(spectrum, hz - line_hz / 2); i <= last; ++i) {
    const double distance_hz = std::abs(static_cast<double>(i) * spectrum.bin_hz - hz);
    if (distance_hz > lobe) powers.push_back(spectrum.power[i]);
  }
  return powers;
}

double floor_of(std::vector<double> powers, const EnvelopeSpectrum& spectrum) {
  return std::max(median(std::move(powers)), spectrum.rounding);
}

double free_harmonic_db(const EnvelopeSpectrum& spectrum, int number, double line_hz) {
  const double hz = number * line_hz;
  if (bin_at(spectrum, hz + line_hz / 2) >= spectrum.power.size()) return 0;
  std::vector<double> next = powers_next_to(spectrum, number, line_hz);
  if (next.empty()) return 0;
  double line = spectrum.rounding;
  const std::size_t last = bin_at(spectrum, hz * (1 + line_tolerance));
  for (std::size_t i = bin_at(spectrum, hz * (1 - line_tolerance)); i <= last; ++i) {
    line = std::max(line, spectrum.power[i]);
  }
  return 10 * std::log10(line / floor_of(std::move(next), spectrum));
}

}  // namespace

EnvelopeSpectrum envelope_spectrum(const Windows& windows, double rate_hz) {
  if (windows.size() == 0) throw std::logic_error("an envelope spectrum needs at least one window");
  const auto length = static_cast<double>(windows.cols());
  const double mean_square = windows.squaredNorm() / static_cast<double>(windows.size());
  const Eigen::ArrayXd power = mean_power_spectrum(envelopes(windows), padding);
  return {.power = {power.begin(), power.end()},
          .bin_hz = rate_hz / (padding * length),
          .resolution_hz = rate_hz / length,
          .averages = static_cast<double>(windows.rows()),
          .rounding =
              rounding_power * mean_square * length * length + std::numeric_limits<double>::min()};
}

double free_harmonics_db(const EnvelopeSpectrum& spectrum, double line_hz) {
  double sum = 0;
  for (int number = 1; number <= line_harmonics; ++number) {
    sum += free_harmonic_db(spectrum, number, line_hz);
  }
  return sum / line_harmonics;
}

double CommonLine::mean_db() const {
  return std::accumulate(decibels.begin(), decibels.end(), 0.0) / line_harmonics;
}

bool can_measure_common_line(const EnvelopeSpectrum& spectrum, double line_hz) {
  const double last_hz = (line_harmonics + 0.5) * line_hz;
  return spectrum.bin_hz > 0 &&
         lobe_hz(spectrum, line_harmonics, line_hz) <= largest_lobe * line_hz &&
         bin_at(spectrum, last_hz) < spectrum.power.size();
}

CommonLine common_line(const EnvelopeSpectrum& spectrum, double line_hz) {
  std::array<double, line_harmonics> floors{};
  for (int n = 1; n <= line_harmonics; ++n) {
    floors.at(n - 1) = floor_of(powers_next_to(spectrum, n, line_hz), spectrum);
  }
  CommonLine best;
  best.decibels.fill(-std::numeric_limits<double>::infinity());
  const double step_hz = spectrum.bin_hz / line_harmonics;
  const auto last = std::lround(line_tolerance * line_hz / step_hz);
  for (long i = -last; i <= last; ++i) {
    CommonLine here{.hz = line_hz + static_cast<double>(i) * step_hz};
    for (int n = 1; n <= line_harmonics; ++n) {
      const double power =
          std::max(spectrum.power[bin_at(spectrum, n * here.hz)], spectrum.rounding);
      here.decibels.at(n - 1) = 10 * std::log10(power / floors.at(n - 1));
    }
    if (here.mean_db() > best.mean_db()) best = here;
  }
  return best;
}

double common_slip_height(const OrderSpectrum& spectrum, double order, int count, double lowest) {
  double best = -std::numeric_limits<double>::infinity();
  for (int i = -slip_steps; i <= slip_steps; ++i) {
    double sum = 0;
    for (int n = 1; n <= count; ++n) {
      sum += spectrum.at(n * order * (1 + i * slip_step), lowest, highest);
    }
    best = std::max(best, sum / count);
  }
  return best;
}

}  // namespace piae::spectra

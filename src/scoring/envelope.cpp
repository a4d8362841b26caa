#include "scoring/envelope.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <vector>

#include "bearing/strikes.hpp"
#include "scoring/spectrum.hpp"
#include "scoring/statistics.hpp"
#include "spectra/fft.hpp"

namespace piae::scoring {

namespace {

using Eigen::Index;
using Complex = std::complex<double>;

constexpr int harmonics = 3;
constexpr Index padding = 4;
constexpr double tolerance = 0.02;
constexpr double lobe_bins = 2;  // half of the main lobe of Hann's window, before padding
// A power that is a smaller part of the windows' power than this is rounding alone.
constexpr double rounding_power = 1e-20;

/// Doubles the positive frequencies and removes the negative ones.
void make_analytic(std::vector<Complex>& spectrum) {
  const auto zero = spectrum.begin();
  const auto half = std::ssize(spectrum) / 2;
  const auto negative = zero + half + 1;
  std::for_each(zero + 1, negative - (std::ssize(spectrum) + 1) % 2, [](Complex& x) { x *= 2; });
  std::fill(negative, spectrum.end(), Complex(0));
}

struct Spectrum {
  Eigen::ArrayXd power;
  double bin_hz = 0;
  double rounding = 0;  ///< a power below this is rounding alone

  [[nodiscard]] Index bin(double hz) const { return std::lround(hz / bin_hz); }
};

Spectrum envelope_spectrum(const Windows& windows, double rate_hz) {
  const auto length = static_cast<double>(windows.cols());
  const double mean_square = windows.squaredNorm() / static_cast<double>(windows.size());
  return {mean_power_spectrum(envelopes(windows), padding), rate_hz / (padding * length),
          rounding_power * mean_square * length * length + std::numeric_limits<double>::min()};
}

/// How far one harmonic stands out, in dB. The line may lie anywhere within the tolerance and is as
/// wide as the main lobe of Hann's window; only what lies outside of both counts as floor.
double harmonic_db(const Spectrum& spectrum, int number, double line_hz) {
  const double hz = number * line_hz;
  const double lobe_hz = tolerance * hz + lobe_bins * padding * spectrum.bin_hz;
  const Index last = spectrum.bin(hz + line_hz / 2);
  if (last >= spectrum.power.size()) return 0;
  std::vector<double> beside;
  double line = spectrum.rounding;
  for (Index i = spectrum.bin(hz - line_hz / 2); i <= last; ++i) {
    const double distance_hz = std::abs(static_cast<double>(i) * spectrum.bin_hz - hz);
    if (distance_hz > lobe_hz) beside.push_back(spectrum.power[i]);
  }
  if (beside.empty()) return 0;
  for (Index i = spectrum.bin(hz * (1 - tolerance)); i <= spectrum.bin(hz * (1 + tolerance)); ++i) {
    line = std::max(line, spectrum.power[i]);
  }
  return 10 * std::log10(line / std::max(median(beside), spectrum.rounding));
}

}  // namespace

Windows envelopes(const Windows& windows) {
  Windows result(windows.rows(), windows.cols());
  std::vector<Complex> samples(static_cast<std::size_t>(windows.cols()));
  std::vector<Complex> spectrum(samples.size());
  for (Index i = 0; i < windows.rows(); ++i) {
    Eigen::Map<Eigen::RowVectorXcd> row(samples.data(), windows.cols());
    row = (windows.row(i).array() - windows.row(i).mean()).cast<Complex>();
    spectra::fft(samples, spectrum);
    make_analytic(spectrum);
    spectra::inverse_fft(spectrum, samples);
    // cwiseAbs would call hypot, which guards against overflow that cannot happen here and is
    // slower.
    result.row(i) = row.cwiseAbs2().cwiseSqrt();
  }
  return result;
}

double fault_line_hz(const signal::DatasetInfo& info, signal::Defect defect) {
  return bearing::strike_frequency_hz(info.bearing, defect, info.tested_speed_rpm());
}

double fault_line_db(const Windows& windows, double line_hz, double rate_hz) {
  if (windows.size() == 0) throw std::logic_error("no windows have no envelope spectrum");
  const Spectrum spectrum = envelope_spectrum(windows, rate_hz);
  double sum = 0;
  for (int number = 1; number <= harmonics; ++number) {
    sum += harmonic_db(spectrum, number, line_hz);
  }
  return sum / harmonics;
}

}  // namespace piae::scoring

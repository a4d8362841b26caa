#include "scoring/spectrum.hpp"

#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "spectra/fft.hpp"

namespace piae::scoring {

namespace {

using Eigen::Index;

constexpr double floor_to_mean = 1e-10;  // of powers, as a part of the real spectrum's mean

/// Hann's window, made once for each length and thread: windows often come one by one.
const Eigen::RowVectorXd& taper_of(Index length) {
  thread_local std::map<Index, Eigen::RowVectorXd> tapers;
  Eigen::RowVectorXd& taper = tapers[length];
  if (taper.size() == 0) taper = hann(length);
  return taper;
}

}  // namespace

Eigen::RowVectorXd hann(Index length) {
  Eigen::RowVectorXd taper(length);
  for (Index i = 0; i < length; ++i) {
    taper[i] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) /
                                    static_cast<double>(length));
  }
  return taper;
}

Eigen::ArrayXd mean_power_spectrum(const Windows& windows, Index padding) {
  const Index bins = padding * windows.cols() / 2 + 1;
  const Eigen::RowVectorXd& taper = taper_of(windows.cols());
  Eigen::ArrayXd power = Eigen::ArrayXd::Zero(bins);
  std::vector<double> tapered(static_cast<std::size_t>(padding * windows.cols()));
  std::vector<std::complex<double>> spectrum(tapered.size() / 2 + 1);
  for (Index i = 0; i < windows.rows(); ++i) {
    Eigen::Map<Eigen::RowVectorXd>(tapered.data(), windows.cols()) =
        (windows.row(i).array() - windows.row(i).mean()) * taper.array();
    spectra::fft(tapered, spectrum);
    for (Index bin = 0; bin < bins; ++bin) {
      power[bin] += std::norm(spectrum[static_cast<std::size_t>(bin)]);
    }
  }
  return power / static_cast<double>(windows.rows());
}

double spectral_distance_db(const Windows& generated, const Windows& real) {
  if (generated.cols() != real.cols() || real.cols() < 2) {
    throw std::logic_error("spectra are compared of windows of equal length, 2 or more");
  }
  const Index bins = real.cols() / 2;  // without the first: the mean is gone
  const Eigen::ArrayXd reference = mean_power_spectrum(real).tail(bins);
  const double floor = floor_to_mean * reference.mean();
  if (!(floor > 0)) throw std::logic_error("the real windows are silent");
  const Eigen::ArrayXd power = mean_power_spectrum(generated).tail(bins);
  const Eigen::ArrayXd decibels = 10 * (power.max(floor) / reference.max(floor)).log10();
  return std::sqrt(decibels.square().mean());
}

}  // namespace piae::scoring

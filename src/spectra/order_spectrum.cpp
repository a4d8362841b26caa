#include "spectra/order_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "spectra/floors.hpp"
#include "spectra/power.hpp"

namespace piae::spectra {

namespace {

using Eigen::Index;

constexpr Index padding = 2;
constexpr double floor_orders = 1.6;
constexpr Index least_floor_bins = 9;
// Beyond a band's width its envelope holds only rounding errors at the bins and leakage between
// them. A floor of at least this fraction of the mean power keeps these from looking like lines.
constexpr double least_floor = 1e-4;
constexpr double least_ratio = 1e-3;       // keeps the logarithm of a silent place finite
constexpr double least_amplitude = 1e-12;  // of the largest; keeps silent bins silent

/// Interpolates linearly between two numbers of an array; returns the last number beyond the end.
double between(const Eigen::ArrayXd& values, double place) {
  const double inside = std::min(place, static_cast<double>(values.size() - 1));
  const Index before = std::min(static_cast<Index>(inside), values.size() - 2);
  return std::lerp(values[before], values[before + 1], inside - static_cast<double>(before));
}

/// Returns the squared envelope of a band of a whitened half spectrum.
Eigen::RowVectorXd squared_envelope(const Eigen::ArrayXcd& whitened, const Eigen::ArrayXd& response,
                                    Index length) {
  std::vector<std::complex<double>> spectrum(static_cast<std::size_t>(length));
  Eigen::Map<Eigen::ArrayXcd>(spectrum.data(), whitened.size()) = 2 * response * whitened;
  std::vector<std::complex<double>> analytic;
  // Use Eigen's transform directly: compiled here, its last bits differ from those of
  // spectra::inverse_fft, and stored results depend on them.
  Eigen::FFT<double>().inv(analytic, spectrum);
  return Eigen::Map<const Eigen::RowVectorXcd>(analytic.data(), length).cwiseAbs2();
}

void prewhiten(double power, Eigen::ArrayXcd& spectrum) {
  const Eigen::ArrayXd amplitudes = spectrum.abs();
  spectrum /= (amplitudes + least_amplitude * amplitudes.maxCoeff()).pow(power);
}

/// Returns how far the bins of an envelope spectrum stand above the floor. The floor is estimated
/// from the bins that exist without padding.
Eigen::ArrayXd above_floor(const Eigen::ArrayXd& power, Index floor_bins) {
  const Index coarse = (power.size() - 1) / padding + 1;
  const Eigen::ArrayXd unpadded = Eigen::Map<const Eigen::ArrayXd, 0, Eigen::InnerStride<>>(
      power.data(), coarse, Eigen::InnerStride<>(padding));
  const Eigen::ArrayXd floor = running_median(unpadded, floor_bins) / std::numbers::ln2;
  const double least = least_floor * power.mean() + std::numeric_limits<double>::min();
  Eigen::ArrayXd heights(power.size());
  for (Index i = 0; i < heights.size(); ++i) {
    const double here = std::max(between(floor, static_cast<double>(i) / padding), least);
    heights[i] = std::log10(power[i] / here + least_ratio);
  }
  return heights;
}

}  // namespace

double OrderSpectrum::at(double order, double lowest, double highest) const {
  const double place = (order - first) / step;
  const auto before = static_cast<Index>(place);
  return std::lerp(std::clamp(heights[before], lowest, highest),
                   std::clamp(heights[before + 1], lowest, highest),
                   place - static_cast<double>(before));
}

OrderSpectrum order_spectrum(const Eigen::RowVectorXd& window, const FilterBank& bank,
                             double shaft_hz, double last, double prewhitening) {
  const Index length = window.size();
  const double coarse_hz = bank.rate_hz / static_cast<double>(length);
  const double bins_an_order = shaft_hz / coarse_hz;
  const Index floor_bins =
      std::max(static_cast<Index>(floor_orders * bins_an_order), least_floor_bins) / 2 * 2 + 1;
  const Index used = std::min<Index>(
      padding * (static_cast<Index>((last + OrderSpectrum::step) * bins_an_order) + floor_bins) + 1,
      padding * length / 2 + 1);

  Eigen::ArrayXcd whitened = whitened_spectrum(window, bank.rate_hz);
  if (prewhitening > 0) prewhiten(prewhitening, whitened);
  const auto orders =
      static_cast<Index>(std::ceil((last - OrderSpectrum::first) / OrderSpectrum::step)) + 2;
  OrderSpectrum spectrum{Eigen::ArrayXd::Zero(orders)};
  for (const Eigen::ArrayXd& response : bank.responses) {
    const Windows envelope = squared_envelope(whitened, response, length);
    const Eigen::ArrayXd power = mean_power_spectrum(envelope, padding).head(used);
    const Eigen::ArrayXd heights = above_floor(power, floor_bins);
    for (Index i = 0; i < orders; ++i) {
      const double order = OrderSpectrum::first + static_cast<double>(i) * OrderSpectrum::step;
      spectrum.heights[i] += between(heights, padding * bins_an_order * order);
    }
  }
  spectrum.heights /= static_cast<double>(bank.responses.size());
  return spectrum;
}

}  // namespace piae::spectra

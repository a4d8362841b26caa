#include "scoring/waveform.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <vector>

#include "spectra/fft.hpp"
#include "spectra/power.hpp"

namespace piae::scoring {

namespace {

using Eigen::Index;
using Complex = std::complex<double>;

constexpr double floor_to_mean = 1e-10;  // floor of powers, as a part of the real spectrum's mean

void require_pairs(const Windows& generated, const Windows& real) {
  if (generated.rows() != real.rows() || generated.cols() != real.cols() || real.size() == 0) {
    throw std::logic_error("waveforms need pairs of windows of equal length");
  }
}

double root_mean_square(const Eigen::Ref<const Eigen::RowVectorXd>& difference) {
  return std::sqrt(difference.squaredNorm() / static_cast<double>(difference.size()));
}

/// Finds the s that maximises sum_n real(n) generated(n + s), indices modulo the length.
class BestShift {
 public:
  explicit BestShift(Index length)
      : spectrum_(static_cast<std::size_t>(length / 2 + 1)),
        reference_(spectrum_.size()),
        correlation_(static_cast<std::size_t>(length)) {}

  Index operator()(const double* generated, const double* real) {
    spectra::fft({generated, correlation_.size()}, spectrum_);
    spectra::fft({real, correlation_.size()}, reference_);
    for (std::size_t i = 0; i < spectrum_.size(); ++i) spectrum_[i] *= std::conj(reference_[i]);
    spectra::inverse_fft(spectrum_, correlation_);
    return std::ranges::max_element(correlation_) - correlation_.begin();
  }

 private:
  std::vector<Complex> spectrum_;
  std::vector<Complex> reference_;
  std::vector<double> correlation_;
};

}  // namespace

double rmse(const Windows& generated, const Windows& real) {
  require_pairs(generated, real);
  double sum = 0;
  for (Index i = 0; i < real.rows(); ++i) sum += root_mean_square(generated.row(i) - real.row(i));
  return sum / static_cast<double>(real.rows());
}

double aligned_rmse(const Windows& generated, const Windows& real) {
  require_pairs(generated, real);
  BestShift best_shift(generated.cols());
  Windows shifted(generated.rows(), generated.cols());
  for (Index i = 0; i < real.rows(); ++i) {
    const Index head = generated.cols() - best_shift(generated.row(i).data(), real.row(i).data());
    shifted.row(i) << generated.row(i).tail(head), generated.row(i).head(generated.cols() - head);
  }
  return rmse(shifted, real);
}

double amplitude_ratio(const Windows& generated, const Windows& real) {
  require_pairs(generated, real);
  if (real.squaredNorm() == 0) throw std::logic_error("the real windows are silent");
  return std::sqrt(generated.squaredNorm() / real.squaredNorm());
}

double spectral_distance_db(const Windows& generated, const Windows& real) {
  if (generated.cols() != real.cols() || real.cols() < 2) {
    throw std::logic_error("spectra need windows of one length, 2 samples or more");
  }
  const Index bins = real.cols() / 2;  // without the first: the mean is removed
  const Eigen::ArrayXd reference = spectra::mean_power_spectrum(real).tail(bins);
  const double floor = floor_to_mean * reference.mean();
  if (!(floor > 0)) throw std::logic_error("the real windows are silent");
  const Eigen::ArrayXd power = spectra::mean_power_spectrum(generated).tail(bins);
  const Eigen::ArrayXd decibels = 10 * (power.max(floor) / reference.max(floor)).log10();
  return std::sqrt(decibels.square().mean());
}

}  // namespace piae::scoring

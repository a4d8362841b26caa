#include "scoring/waveform.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace piae::scoring {

namespace {

using Eigen::Index;
using Complex = std::complex<double>;

void require_pairs(const Windows& generated, const Windows& real) {
  if (generated.rows() != real.rows() || generated.cols() != real.cols() || real.size() == 0) {
    throw std::logic_error("windows are compared in pairs of equal length");
  }
}

double root_mean_square(const Eigen::Ref<const Eigen::RowVectorXd>& difference) {
  return std::sqrt(difference.squaredNorm() / static_cast<double>(difference.size()));
}

std::vector<Complex> spectrum(Eigen::FFT<double>& fft, const Windows& windows, Index row) {
  const double* first = windows.row(row).data();
  const std::vector<double> samples(first, first + windows.cols());
  std::vector<Complex> bins;
  fft.fwd(bins, samples);
  return bins;
}

/// The s that makes sum_n real(n) generated(n + s) largest, indices modulo the length.
Index best_shift(Eigen::FFT<double>& fft, const Windows& generated, const Windows& real,
                 Index row) {
  std::vector<Complex> product = spectrum(fft, generated, row);
  const std::vector<Complex> reference = spectrum(fft, real, row);
  for (std::size_t i = 0; i < product.size(); ++i) product[i] *= std::conj(reference[i]);
  std::vector<double> correlation;
  fft.inv(correlation, product);
  return std::max_element(correlation.begin(), correlation.end()) - correlation.begin();
}

}  // namespace

double rmse(const Windows& generated, const Windows& real) {
  require_pairs(generated, real);
  double sum = 0;
  for (Index i = 0; i < real.rows(); ++i) sum += root_mean_square(generated.row(i) - real.row(i));
  return sum / static_cast<double>(real.rows());
}

double aligned_rmse(const Windows& generated, const Windows& real) {
  require_pairs(generated, real);
  Eigen::FFT<double> fft;
  Windows shifted(generated.rows(), generated.cols());
  for (Index i = 0; i < real.rows(); ++i) {
    const Index head = generated.cols() - best_shift(fft, generated, real, i);
    shifted.row(i) << generated.row(i).tail(head), generated.row(i).head(generated.cols() - head);
  }
  return rmse(shifted, real);
}

double amplitude_ratio(const Windows& generated, const Windows& real) {
  require_pairs(generated, real);
  if (real.squaredNorm() == 0) throw std::logic_error("the real windows are silent");
  return std::sqrt(generated.squaredNorm() / real.squaredNorm());
}

}  // namespace piae::scoring

#include "scoring/mmd.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace piae::scoring {

namespace {

using Eigen::Index;

constexpr Index block_rows = 64;  // a block of distances fits into the cache

/// Returns the sum of f(squared distances) over all pairs of rows. The squared distance of x and y
/// is
/// x
/// ^2 +
/// y
/// ^2 - 2 x.y; one matrix product gives all x.y of a block of rows. The sums of the blocks are
/// added in order, so that threads do not change the result.
template <class F>
double sum_over_pairs(const Windows& x, const Windows& y, const F& f) {
  const Eigen::ArrayXd x_norms = x.rowwise().squaredNorm();
  const Eigen::ArrayXd y_norms = y.rowwise().squaredNorm();
  const Index blocks = (x.rows() + block_rows - 1) / block_rows;
  std::vector<double> sums(static_cast<std::size_t>(blocks));
#pragma omp parallel for schedule(dynamic)
  for (Index block = 0; block < blocks; ++block) {
    const Index first = block * block_rows;
    const Index rows = std::min(block_rows, x.rows() - first);
    Eigen::ArrayXXd distances = (-2.0 * x.middleRows(first, rows) * y.transpose()).array();
    distances.colwise() += x_norms.segment(first, rows);
    distances.rowwise() += y_norms.transpose();
    sums[static_cast<std::size_t>(block)] = f(distances.max(0.0));
  }
  double sum = 0;
  for (const double part : sums) sum += part;
  return sum;
}

/// Returns the sum of the five kernels over all pairs. One exponential suffices, because each
/// kernel is the square of the next wider one.
double sum_of_kernels(const Windows& x, const Windows& y, double bandwidth) {
  return sum_over_pairs(x, y, [bandwidth](const auto& distances) {
    Eigen::ArrayXXd kernel = (distances * (-1.0 / (16.0 * bandwidth))).exp();
    double sum = kernel.sum();
    for (int narrower = 0; narrower < 4; ++narrower) {
      kernel = kernel.square();
      sum += kernel.sum();
    }
    return sum;
  });
}

}  // namespace

double mean_squared_distance(const Windows& windows) {
  if (windows.rows() < 2) throw std::logic_error("a distance needs two windows or more");
  const auto n = static_cast<double>(windows.rows());
  return sum_over_pairs(windows, windows, [](const auto& distances) { return distances.sum(); }) /
         (n * (n - 1));
}

double mmd_squared(const Windows& x, const Windows& y, double squared_distance) {
  if (x.rows() != y.rows() || x.cols() != y.cols() || x.rows() == 0) {
    throw std::logic_error("MMD needs equal numbers of windows of equal length");
  }
  if (!(squared_distance > 0)) throw std::logic_error("MMD needs a positive squared distance");
  const double bandwidth = squared_distance / 4;
  const auto n = static_cast<double>(x.rows());
  return (sum_of_kernels(x, x, bandwidth) + sum_of_kernels(y, y, bandwidth) -
          2 * sum_of_kernels(x, y, bandwidth)) /
         (n * n);
}

}  // namespace piae::scoring

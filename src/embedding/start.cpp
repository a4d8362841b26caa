#include "embedding/start.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/random.hpp"

namespace piae::embedding {

using Eigen::Index;

namespace {

constexpr double start_deviation = 1e-4;
constexpr double noise_deviation = 1e-6;

/// A component with less than this fraction of the first one's variance is rounding noise of
/// coordinates that were once in single precision.
constexpr double least_variance = 1e-12;

/// Returns the eigenvector with the sign that makes its largest entry positive.
Eigen::VectorXd with_fixed_sign(const Eigen::VectorXd& direction) {
  Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return direction[largest] < 0 ? Eigen::VectorXd(-direction) : direction;
}

}  // namespace

Plane first_places(const Points& points) {
  const Points centred = points.rowwise() - points.colwise().mean();
  const Eigen::MatrixXd covariance =
      centred.transpose() * centred / static_cast<double>(points.rows());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);  // smallest first
  const Eigen::VectorXd variances = solver.eigenvalues().reverse();
  const double scale = start_deviation / std::sqrt(variances[0]);

  Plane places(points.rows(), 2);
  for (Index k = 0; k < 2; ++k) {
    if (k < variances.size() && variances[k] > 0 && variances[k] > least_variance * variances[0]) {
      const Eigen::VectorXd direction = solver.eigenvectors().col(variances.size() - 1 - k);
      places.col(k) = scale * (centred * with_fixed_sign(direction)).array();
    } else {
      Stream noise(k == 0 ? "tsne/start/component1" : "tsne/start/component2");
      std::ranges::generate(places.col(k), [&] { return noise.normal(0, noise_deviation); });
    }
  }
  return places;
}

}  // namespace piae::embedding

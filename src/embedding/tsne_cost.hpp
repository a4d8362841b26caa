#pragma once

#include <Eigen/Core>

#include "embedding/points.hpp"

namespace piae::embedding {

/// Returns the cost that t-SNE minimises: the Kullback-Leibler divergence sum p_ij ln(p_ij / q_ij)
/// of the pair probabilities p [N, N] from q_ij = w_ij / sum w, where w_ij = 1 / (1 + |y_i -
/// y_j|^2) for the points y of the plane (van der Maaten and Hinton 2008, eqs. 2 and 4). Uses
/// double precision.
double kl_divergence(const Eigen::MatrixXd& probabilities, const Plane& points);

/// The gradient of that cost (same paper, eq. 5): 4 sum_j (e p_ij - q_ij) w_ij (y_i - y_j) for
/// point i. Uses single precision, which gives about five digits: enough for a descent, in half the
/// time. The result does not depend on the number of threads.
class KlGradient {
 public:
  explicit KlGradient(const Eigen::MatrixXd& probabilities);

  /// `exaggeration` is e, the factor of the probabilities.
  [[nodiscard]] Plane operator()(const Plane& points, double exaggeration = 1) const;

 private:
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> probabilities_;
};

}  // namespace piae::embedding

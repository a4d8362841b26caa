#pragma once

#include <Eigen/Core>

#include "embedding/points.hpp"

namespace piae::embedding {

/// What t-SNE makes small: the Kullback-Leibler divergence sum p_ij ln(p_ij / q_ij) of the pair
/// probabilities p [N, N] from q_ij = w_ij / sum w, where w_ij = 1 / (1 + |y_i - y_j|^2) for the
/// points y of the plane (van der Maaten and Hinton 2008, eqs. 2 and 4). In double precision.
double kl_divergence(const Eigen::MatrixXd& probabilities, const Plane& points);

/// Its gradient (the same paper, eq. 5), 4 sum_j (e p_ij - q_ij) w_ij (y_i - y_j) for point i.
/// Terms are in single precision, which gives about five digits: a descent needs no more, and takes
/// half the time. The result does not depend on the number of threads.
class KlGradient {
 public:
  explicit KlGradient(const Eigen::MatrixXd& probabilities);

  /// `exaggeration` is e, by which the probabilities are multiplied.
  [[nodiscard]] Plane operator()(const Plane& points, double exaggeration = 1) const;

 private:
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> probabilities_;
};

}  // namespace piae::embedding

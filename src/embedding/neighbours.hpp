#pragma once

#include <Eigen/Core>

namespace piae::embedding {

/// Returns the probability that a point picks each other point as its neighbour (van der Maaten and
/// Hinton 2008, eq. 1): p_j = exp(-beta d_j) / sum_k exp(-beta d_k), where d are the squared
/// distances of the others. beta = 1 / (2 sigma^2) is chosen so that the perplexity exp(-sum_j p_j
/// ln p_j) is the given one, to 8 digits. The perplexity must be at least 1 and below a third of
/// the number of others. If more points than `perplexity` are equally near, they share the
/// probability equally, and the perplexity is their number.
Eigen::ArrayXd neighbour_probabilities(const Eigen::ArrayXd& squared_distances, double perplexity);

/// Returns the probability of each pair of N points from their squared distances [N, N]: p_ij =
/// (p_j|i + p_i|j) / 2N (same paper, Section 3.1). The result is [N, N], symmetric, 0 on the
/// diagonal, and sums to 1.
Eigen::MatrixXd pair_probabilities(const Eigen::MatrixXd& squared_distances, double perplexity);

}  // namespace piae::embedding

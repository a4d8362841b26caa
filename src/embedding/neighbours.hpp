#pragma once

#include <Eigen/Core>

namespace piae::embedding {

/// How probable it is that a point picks each of the others as its neighbour (van der Maaten and
/// Hinton 2008, eq. 1): p_j = exp(-beta d_j) / sum_k exp(-beta d_k), where d are the squared
/// distances of the others. beta = 1 / (2 sigma^2) is the one with which the perplexity exp(-sum_j
/// p_j ln p_j) is the given one, to 8 digits. The perplexity must be at least 1 and below a third
/// of the number of others. Where more others than that are equally near, none is preferred: they
/// share all, and the perplexity is their number.
Eigen::ArrayXd neighbour_probabilities(const Eigen::ArrayXd& squared_distances, double perplexity);

/// How probable each pair of N points is: p_ij = (p_j|i + p_i|j) / 2N (the same paper, Section
/// 3.1), of their squared distances [N, N]. The result is [N, N], symmetric, 0 for a point with
/// itself, and adds up to 1.
Eigen::MatrixXd pair_probabilities(const Eigen::MatrixXd& squared_distances, double perplexity);

}  // namespace piae::embedding

#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "embedding/points.hpp"

/// Reference for t-SNE's cost: plain loops over its equations. Shares nothing with src/embedding
/// but the type of the points.
namespace piae::embedding::reference {

using Table = std::vector<std::vector<double>>;

inline double squared_distance(const Points& points, Eigen::Index i, Eigen::Index j) {
  double sum = 0;
  for (Eigen::Index k = 0; k < points.cols(); ++k) sum += std::pow(points(i, k) - points(j, k), 2);
  return sum;
}

inline double perplexity_of(const std::vector<double>& probabilities) {
  double bits = 0;
  for (const double p : probabilities) bits -= p > 0 ? p * std::log2(p) : 0;
  return std::pow(2.0, bits);
}

/// Eq. 1, with one bandwidth for all points but i.
inline std::vector<double> neighbours_of(const Points& points, Eigen::Index i, double sigma) {
  std::vector<double> p(static_cast<std::size_t>(points.rows()));
  double sum = 0;
  for (Eigen::Index j = 0; j < points.rows(); ++j) {
    const double weight = std::exp(-squared_distance(points, i, j) / (2 * sigma * sigma));
    p[static_cast<std::size_t>(j)] = i == j ? 0 : weight;
    sum += i == j ? 0 : weight;
  }
  for (double& probability : p) probability /= sum;
  return p;
}

/// Returns p_ij of Section 3.1; finds the bandwidths by bisection.
inline Table pair_probabilities(const Points& points, double perplexity) {
  const auto n = static_cast<std::size_t>(points.rows());
  Table conditional(n);
  for (std::size_t i = 0; i < n; ++i) {
    double low = 1e-3;
    double high = 1e3;
    while (high / low > 1 + 1e-12) {
      const double sigma = std::sqrt(low * high);
      conditional[i] = neighbours_of(points, static_cast<Eigen::Index>(i), sigma);
      (perplexity_of(conditional[i]) < perplexity ? low : high) = sigma;
    }
  }
  Table joint(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      joint[i][j] = (conditional[i][j] + conditional[j][i]) / (2 * static_cast<double>(n));
    }
  }
  return joint;
}

/// Eqs. 2 and 4.
inline double kl_divergence(const Table& p, const Points& map) {
  double weights = 0;
  for (Eigen::Index i = 0; i < map.rows(); ++i) {
    for (Eigen::Index j = 0; j < map.rows(); ++j) {
      if (i != j) weights += 1 / (1 + squared_distance(map, i, j));
    }
  }
  double sum = 0;
  for (Eigen::Index i = 0; i < map.rows(); ++i) {
    for (Eigen::Index j = 0; j < map.rows(); ++j) {
      const double probability = p[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      const double q = 1 / (1 + squared_distance(map, i, j)) / weights;
      if (i != j && probability > 0) sum += probability * std::log(probability / q);
    }
  }
  return sum;
}

}  // namespace piae::embedding::reference

#include "embedding/neighbours.hpp"

#include <cmath>
#include <cstddef>

#include "base/parallel.hpp"

namespace piae::embedding {

using Eigen::Index;

namespace {

/// Gaussian weights of points, before division by their sum.
struct GaussianWeights {
  Eigen::ArrayXd weights;
  double sum;
  double entropy;  ///< entropy of the weights divided by their sum, natural logarithm

  GaussianWeights(const Eigen::ArrayXd& squared_distances, double beta)
      : weights((-beta * squared_distances).exp()),
        sum(weights.sum()),
        entropy(std::log(sum) + beta * (weights * squared_distances).sum() / sum) {}
};

}  // namespace

Eigen::ArrayXd neighbour_probabilities(const Eigen::ArrayXd& squared_distances, double perplexity) {
  // Subtracting the smallest distance does not change the probabilities. The nearest point then has
  // weight 1, so the sum of the weights is never 0. Dividing by the largest distance bounds beta
  // for all inputs.
  Eigen::ArrayXd beyond = squared_distances - squared_distances.minCoeff();
  const double largest = beyond.maxCoeff();
  if (largest > 0) beyond /= largest;

  // At beta = 1 no weight is below 1/e, so the entropy is at least ln(n) - 1, which exceeds that of
  // n/3. At the upper limit only points as near as the nearest have any weight.
  double low = 0;
  double high = 200;
  const double wanted = std::log(perplexity);
  constexpr double tolerance = 1e-8;
  constexpr int most_halvings = 60;  // limit if no beta gives the wanted entropy
  for (int halving = 0;; ++halving) {
    const double middle = (low + high) / 2;
    GaussianWeights found(beyond, std::exp(middle));
    if (std::abs(found.entropy - wanted) < tolerance || halving == most_halvings) {
      return found.weights / found.sum;
    }
    (found.entropy > wanted ? low : high) = middle;
  }
}

Eigen::MatrixXd pair_probabilities(const Eigen::MatrixXd& squared_distances, double perplexity) {
  const Index n = squared_distances.rows();
  Eigen::MatrixXd of_neighbours(n, n);  // column i: neighbour probabilities of point i
  parallel_for(static_cast<std::size_t>(n), [&](std::size_t point) {
    const auto i = static_cast<Index>(point);
    const Index after = n - 1 - i;
    Eigen::ArrayXd others(n - 1);
    others << squared_distances.col(i).head(i), squared_distances.col(i).tail(after);
    const Eigen::ArrayXd p = neighbour_probabilities(others, perplexity);
    of_neighbours.col(i) << p.head(i), 0, p.tail(after);
  });
  return (of_neighbours + of_neighbours.transpose()) / (2.0 * static_cast<double>(n));
}

}  // namespace piae::embedding

#include "embedding/tsne.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/columns.hpp"
#include "base/error.hpp"
#include "embedding/neighbours.hpp"
#include "embedding/start.hpp"
#include "embedding/tsne_cost.hpp"

namespace piae::embedding {

using Eigen::Index;

namespace {

void check_tsne(const Points& points, const TsneOptions& options) {
  const auto others = static_cast<double>(points.rows() - 1);
  if (!(options.perplexity >= 1 && 3 * options.perplexity < others)) {
    throw std::logic_error("t-SNE needs a perplexity from 1 to below (N - 1) / 3");
  }
  if (points.cols() == 0) throw std::logic_error("t-SNE needs points with coordinates");
  if (!(options.exaggeration > 0)) throw std::logic_error("t-SNE needs a positive exaggeration");
  for (Index i = 0; i < points.rows(); ++i) {
    if (!points.row(i).allFinite()) {
      throw Error(Exit::bad_input, "t-SNE: point " + std::to_string(i) +
                                       " has a coordinate that is not finite; remove the point, "
                                       "or find the cause");
    }
  }
}

/// Returns N / exaggeration as in Belkina et al., for a gradient without our factor 4. scikit-learn
/// uses at least 50, with which fewer than about a hundred points oscillate while they are
/// exaggerated: 90 normally distributed points end at a divergence of 0.96 instead of 0.79.
double learning_rate(Index n, double exaggeration) {
  return static_cast<double>(n) / exaggeration / 4;
}

/// Gains are the factors of Jacobs (1988), one per coordinate. A gain grows while the coordinate
/// keeps its direction and shrinks while it alternates.
void descend(Plane& places, const KlGradient& gradient_at, const TsneOptions& options) {
  const double rate = learning_rate(places.rows(), options.exaggeration);
  Plane step = Plane::Zero(places.rows(), 2);
  Plane gains = Plane::Ones(places.rows(), 2);
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const bool exaggerated = iteration < options.exaggerated_iterations;
    const double momentum = exaggerated ? 0.5 : 0.8;
    const Plane gradient = gradient_at(places, exaggerated ? options.exaggeration : 1);
    gains = (gradient * step < 0).select(gains + 0.2, (gains * 0.8).max(0.01));
    step = momentum * step - rate * gains * gradient;
    places += step;
    places.rowwise() -= places.colwise().mean().eval();
  }
}

/// Returns the rows of points, sorted by the first coordinate, then by the second, and so on.
std::vector<Index> sorted_rows(const Points& points) {
  std::vector<Index> rows(static_cast<std::size_t>(points.rows()));
  std::iota(rows.begin(), rows.end(), Index{0});
  std::ranges::stable_sort(rows, [&](Index a, Index b) {
    return std::ranges::lexicographical_compare(points.row(a), points.row(b));
  });
  return rows;
}

}  // namespace

TsneMap tsne(const Points& points, const TsneOptions& options) {
  check_tsne(points, options);
  // Another order would round the sums differently and could lead to another minimum.
  const std::vector<Index> order = sorted_rows(points);
  const Points sorted = points(order, every_column(points));
  const Eigen::MatrixXd probabilities =
      pair_probabilities(squared_distances(sorted), options.perplexity);
  Plane places = first_places(sorted);
  descend(places, KlGradient(probabilities), options);

  TsneMap map{.points = Points(points.rows(), 2),
              .kl_divergence = kl_divergence(probabilities, places)};
  map.points(order, every_column(map.points)) = places.matrix();
  return map;
}

}  // namespace piae::embedding

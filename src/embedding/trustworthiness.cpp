#include "embedding/trustworthiness.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/parallel.hpp"

namespace piae::embedding {

using Eigen::Index;

namespace {

/// Returns the squared distances of all points from point i. The distance of i itself is infinite,
/// so that it comes last.
Eigen::ArrayXd from_point(const Eigen::MatrixXd& squared_distances, Index i) {
  Eigen::ArrayXd distances = squared_distances.col(i);
  distances[i] = std::numeric_limits<double>::infinity();
  return distances;
}

std::vector<Index> nearest(const Eigen::ArrayXd& distances, Index count) {
  std::vector<Index> order(static_cast<std::size_t>(distances.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::partial_sort(order, order.begin() + count, {},
                            [&](Index j) { return std::pair(distances[j], j); });
  order.resize(static_cast<std::size_t>(count));
  return order;
}

/// Returns the rank of j by distance, from 1.
Index rank_among(const Eigen::ArrayXd& distances, Index j) {
  const Index after = distances.size() - 1 - j;
  return 1 + (distances.head(j) <= distances[j]).count() +
         (distances.tail(after) < distances[j]).count();
}

void check_trustworthiness(const Points& points, const Points& map, Index neighbours) {
  if (map.rows() != points.rows()) throw std::logic_error("a map needs one row for each point");
  if (neighbours < 1 || 2 * neighbours >= points.rows()) {
    throw std::logic_error("trustworthiness needs at least one neighbour and fewer than N / 2");
  }
  if (!points.allFinite() || !map.allFinite()) {
    throw std::logic_error("trustworthiness needs finite coordinates");
  }
}

}  // namespace

double trustworthiness(const Points& points, const Points& map, Index neighbours) {
  check_trustworthiness(points, map, neighbours);
  const Index n = points.rows();
  const Eigen::MatrixXd distances = squared_distances(points);
  const Eigen::MatrixXd map_distances = squared_distances(map);
  std::vector<Index> too_far(static_cast<std::size_t>(n));  // sum_j (r(i, j) - k)
  parallel_for(too_far.size(), [&](std::size_t point) {
    const auto i = static_cast<Index>(point);
    const Eigen::ArrayXd from_i = from_point(distances, i);
    for (const Index j : nearest(from_point(map_distances, i), neighbours)) {
      too_far[point] += std::max(rank_among(from_i, j) - neighbours, Index{0});
    }
  });
  const auto sum = static_cast<double>(std::accumulate(too_far.begin(), too_far.end(), Index{0}));
  const auto of_all = static_cast<double>(n * neighbours * (2 * n - 3 * neighbours - 1));
  return 1 - 2 * sum / of_all;
}

}  // namespace piae::embedding

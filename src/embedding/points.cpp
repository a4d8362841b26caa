#include "embedding/points.hpp"

#include <cstddef>

#include "base/parallel.hpp"

namespace piae::embedding {

Eigen::MatrixXd squared_distances(const Points& points) {
  using Eigen::Index;
  Eigen::MatrixXd distances = Eigen::MatrixXd::Zero(points.rows(), points.rows());
  parallel_for(static_cast<std::size_t>(points.rows()), [&](std::size_t point) {
    const auto i = static_cast<Index>(point);
    for (Index j = 0; j < i; ++j) {
      const double distance = (points.row(i) - points.row(j)).squaredNorm();
      distances(i, j) = distance;
      distances(j, i) = distance;
    }
  });
  return distances;
}

}  // namespace piae::embedding

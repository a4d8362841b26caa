#pragma once

#include <Eigen/Core>

namespace piae::embedding {

/// Points, one per row: [N, D]. All coordinates share one unit.
using Points = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Points of a plane: [N, 2]. All x are contiguous, and so are all y, because the arithmetic uses
/// vectors.
using Plane = Eigen::ArrayX2d;

/// Returns the squared Euclidean distances of all pairs of points: [N, N], symmetric to the last
/// bit. Sums squared differences, so equal points are exactly 0 apart.
Eigen::MatrixXd squared_distances(const Points& points);

}  // namespace piae::embedding

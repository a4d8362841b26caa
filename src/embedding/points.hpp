#pragma once

#include <Eigen/Core>

namespace piae::embedding {

/// Points, a row for each: [N, D]. The coordinates have any unit that all of them share.
using Points = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Points of a plane: [N, 2]. All x stand in a row, and all y, as what computes with them needs it.
using Plane = Eigen::ArrayX2d;

/// The squared Euclidean distances of all pairs of points: [N, N], symmetric to the last bit. They
/// are sums of squared differences, so equal points are exactly 0 apart.
Eigen::MatrixXd squared_distances(const Points& points);

}  // namespace piae::embedding

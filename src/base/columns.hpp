#pragma once

#include <Eigen/Core>

namespace piae {

/// Selects every column of a matrix: matrix(rows, every_column(matrix)). Eigen 3.4 calls it
/// Eigen::all, Eigen 5 Eigen::placeholders::all.
template <typename Matrix>
auto every_column(const Matrix& matrix) {
  return Eigen::seqN(Eigen::Index{0}, matrix.cols());
}

}  // namespace piae

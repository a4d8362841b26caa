#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>

#include "nets/dense_kernels.hpp"

namespace piae::nets {

/// Numbers of a batch, one row a window, without gaps.
template <class T>
using RowArray = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The first `columns` of rows.
template <class T>
RowArray<T> copied(Rows<const T> from, std::int64_t rows, std::int64_t columns) {
  RowArray<T> to(rows, columns);
  for (std::int64_t i = 0; i < rows; ++i) std::copy_n(from.row(i), columns, to.row(i).data());
  return to;
}

/// Into rows, from a column on.
template <class T>
void put(const RowArray<T>& from, Rows<T> to, std::int64_t column = 0) {
  for (std::int64_t i = 0; i < from.rows(); ++i) {
    std::copy_n(from.row(i).data(), from.cols(), to.row(i) + column);
  }
}

}  // namespace piae::nets

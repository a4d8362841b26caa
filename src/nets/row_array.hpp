#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/label.hpp"
#include "nets/rows.hpp"

namespace piae::nets {

/// The numbers of a batch: one row per window, without gaps between rows.
template <class T>
using RowArray = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Returns a copy of the first `columns` numbers of each of the first `rows` rows.
template <class T>
RowArray<T> copied(Rows<const T> from, std::int64_t rows, std::int64_t columns) {
  RowArray<T> to(rows, columns);
  for (std::int64_t i = 0; i < rows; ++i) std::copy_n(from.row(i), columns, to.row(i).data());
  return to;
}

/// Copies an array into rows that are held elsewhere, starting at a column.
template <class T>
void put(const RowArray<T>& from, Rows<T> to, std::int64_t column = 0) {
  for (std::int64_t i = 0; i < from.rows(); ++i) {
    std::copy_n(from.row(i).data(), from.cols(), to.row(i) + column);
  }
}

/// Returns the selected rows of `all`, which holds [n, columns] numbers.
template <class T>
RowArray<T> gathered(std::span<const T> all, std::int64_t columns,
                     std::span<const std::size_t> rows) {
  RowArray<T> some(std::ssize(rows), columns);
  for (std::int64_t i = 0; i < some.rows(); ++i) {
    const auto row = static_cast<std::int64_t>(rows[static_cast<std::size_t>(i)]);
    std::copy_n(all.begin() + row * columns, columns, some.row(i).data());
  }
  return some;
}

/// Writes a label as a one-hot vector: `classes` numbers, all 0 except that of the label, which is
/// 1.
template <class T>
void put_one_hot(Label label, std::int64_t classes, T* to) {
  std::fill_n(to, classes, T{0});
  to[label] = 1;
}

}  // namespace piae::nets

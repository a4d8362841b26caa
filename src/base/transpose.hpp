#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/vector.hpp"

namespace piae {

/// One round of transposing a square in registers: exchanges the blocks of `size` lanes that lie
/// opposite each other, in each pair of rows that are `size` apart.
template <std::size_t size, class T, std::size_t n, std::size_t... k>
void exchange_blocks(std::array<Vector<T>, n>& rows, std::index_sequence<k...> /*lanes*/) {
  for (std::size_t i = 0; i < n; ++i) {
    if ((i & size) != 0) continue;
    Vector<T>& upper = rows[i];
    Vector<T>& lower = rows[i + size];
    const Vector<T> first = __builtin_shufflevector(
        upper, lower, static_cast<int>((k & size) == 0 ? k : n + k - size)...);
    lower = __builtin_shufflevector(upper, lower,
                                    static_cast<int>((k & size) == 0 ? k + size : n + k)...);
    upper = first;
  }
}

/// Transposes a square of as many rows as a vector has lanes. `from_row` and `to_row` are the
/// distances from one row to the next.
template <class T>
void transpose_square(const T* from, std::int64_t from_row, T* to, std::int64_t to_row) {
  constexpr std::size_t n = vector_bytes / sizeof(T);
  constexpr auto all = std::make_index_sequence<n>();
  std::array<Vector<T>, n> rows;
  for (std::size_t i = 0; i < n; ++i)
    rows[i] = load(from + static_cast<std::int64_t>(i) * from_row);
  exchange_blocks<1, T>(rows, all);
  if constexpr (n > 2) exchange_blocks<2, T>(rows, all);
  if constexpr (n > 4) exchange_blocks<4, T>(rows, all);
  if constexpr (n > 8) exchange_blocks<8, T>(rows, all);
  for (std::size_t i = 0; i < n; ++i) store(to + static_cast<std::int64_t>(i) * to_row, rows[i]);
}

/// Writes the transpose of `from` [rows, columns] to `to` [columns, rows]. The arrays must not
/// overlap.
template <class T>
void transpose(std::int64_t rows, std::int64_t columns, const T* from, T* to) {
  constexpr std::int64_t n = lanes<T>;
  const auto copy = [&](std::int64_t row, std::int64_t column) {
    to[column * rows + row] = from[row * columns + column];
  };
  const std::int64_t whole_rows = rows / n * n;
  const std::int64_t whole_columns = columns / n * n;
  for (std::int64_t row = 0; row < whole_rows; row += n) {
    for (std::int64_t column = 0; column < whole_columns; column += n) {
      transpose_square(from + row * columns + column, columns, to + column * rows + row, rows);
    }
    for (std::int64_t i = row; i < row + n; ++i) {
      for (std::int64_t column = whole_columns; column < columns; ++column) copy(i, column);
    }
  }
  for (std::int64_t row = whole_rows; row < rows; ++row) {
    for (std::int64_t column = 0; column < columns; ++column) copy(row, column);
  }
}

}  // namespace piae

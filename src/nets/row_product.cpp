#include "nets/row_product.hpp"

#include <algorithm>

#include "base/vector.hpp"

namespace piae::nets {

namespace {

/// How many vectors of a row of C are summed at a time, and of how many rows: as many as the
/// registers hold beside those of a row of B and a number of A.
constexpr int widest_sum = vector_registers >= 32 ? 4 : 2;
constexpr int rows_at_a_time = (vector_registers - widest_sum - 1) / widest_sum;

/// One tile of C, `rows` rows by `vectors` vectors; a, b and c point to where it begins. The loops
/// are unrolled so that GCC keeps the sums in registers.
template <class T, bool add, int rows, int vectors>
void sum_tile(const RowProduct<T>& p, const T* a, const T* b, T* c) {
  Vector<T> sums[rows * vectors];
#pragma GCC unroll 64
  for (int i = 0; i < rows * vectors; ++i) {
    sums[i] = add ? load(c + i / vectors * p.c_row + i % vectors * lanes<T>) : Vector<T>{};
  }
  for (std::int64_t k = 0; k < p.depth; ++k) {
    Vector<T> b_row[vectors];
#pragma GCC unroll 8
    for (int v = 0; v < vectors; ++v) b_row[v] = load(b + v * lanes<T>);
#pragma GCC unroll 64
    for (int i = 0; i < rows * vectors; ++i) {
      sums[i] += b_row[i % vectors] * a[i / vectors * p.a_row];
    }
    a += p.a_column;
    b += p.b_row;
  }
#pragma GCC unroll 64
  for (int i = 0; i < rows * vectors; ++i) {
    store(c + i / vectors * p.c_row + i % vectors * lanes<T>, sums[i]);
  }
}

/// All rows from `row` on of the tiles that begin at `column`: tiles of `rows` rows as long as so
/// many are left; the last one has fewer.
template <class T, bool add, int vectors, int rows = rows_at_a_time>
void sum_rows(const RowProduct<T>& p, std::int64_t column, std::int64_t row = 0) {
  for (; p.rows - row >= rows; row += rows) {
    sum_tile<T, add, rows, vectors>(p, p.a + row * p.a_row, p.b + column,
                                    p.c + row * p.c_row + column);
  }
  if constexpr (rows > 1) sum_rows<T, add, vectors, rows - 1>(p, column, row);
}

template <class T, bool add>
void sum_all(const RowProduct<T>& p) {
  std::int64_t column = 0;
  for (; column + widest_sum * lanes<T> <= p.columns; column += widest_sum * lanes<T>) {
    sum_rows<T, add, widest_sum>(p, column);
  }
  if constexpr (widest_sum > 2) {
    for (; column + 2 * lanes<T> <= p.columns; column += 2 * lanes<T>) {
      sum_rows<T, add, 2>(p, column);
    }
  }
  for (; column < p.columns; column += lanes<T>) sum_rows<T, add, 1>(p, column);
}

}  // namespace

template <class T>
void set_product(const RowProduct<T>& product) {
  sum_all<T, false>(product);
}

template <class T>
void add_product(const RowProduct<T>& product) {
  sum_all<T, true>(product);
}

template void set_product(const RowProduct<float>&);
template void set_product(const RowProduct<double>&);
template void add_product(const RowProduct<float>&);
template void add_product(const RowProduct<double>&);

}  // namespace piae::nets

#include "nets/matrix_product.hpp"

#include <algorithm>

#include "base/vector.hpp"

namespace piae::nets {

namespace {

/// Number of vectors of a row of C that are summed at the same time.
constexpr int widest_tile = vector_registers / 8;

/// Returns the number of rows of C that are summed at the same time: as many as fit into the
/// registers next to a row of B and a number of A. More than 8 do not help.
constexpr int tile_rows(int vectors) {
  return std::min(8, (vector_registers - vectors - 1) / vectors);
}

/// Computes one tile of C, `rows` rows by `vectors` vectors; a, b and c point to its start. The
/// loops are unrolled so that GCC keeps the sums in registers.
template <class T, int rows, int vectors>
void multiply_tile(const MatrixProduct<T>& p, const T* a, const T* b, T* c) {
  Vector<T> sums[rows * vectors];
#pragma GCC unroll 64
  for (Vector<T>& sum : sums) sum = Vector<T>{};
  if (p.add) {
#pragma GCC unroll 64
    for (int i = 0; i < rows * vectors; ++i) {
      sums[i] = load(c + i / vectors * p.c_row + i % vectors * lanes<T>);
    }
  }
  for (std::int64_t block = 0; block < p.blocks; ++block) {
    const T* a_at = a + block * p.a_block;
    const T* b_at = b + block * p.b_block;
    for (std::int64_t k = 0; k < p.depth; ++k) {
      Vector<T> b_row[vectors];
#pragma GCC unroll 8
      for (int v = 0; v < vectors; ++v) b_row[v] = load(b_at + v * lanes<T>);
#pragma GCC unroll 64
      for (int i = 0; i < rows * vectors; ++i) {
        sums[i] += b_row[i % vectors] * a_at[i / vectors * p.a_row];
      }
      a_at += p.a_column;
      b_at += p.b_row;
    }
  }
#pragma GCC unroll 64
  for (int i = 0; i < rows * vectors; ++i) {
    store(c + i / vectors * p.c_row + i % vectors * lanes<T>, sums[i]);
  }
}

/// Computes all rows from `row` on of the tiles that start at `column`, in tiles of `rows` rows and
/// smaller ones at the end. Every tile reads B once, and a batch has few rows, so tiles are as tall
/// as possible.
template <class T, int vectors, int rows = tile_rows(vectors)>
void multiply_rows(const MatrixProduct<T>& p, std::int64_t column, std::int64_t row = 0) {
  for (; row + rows <= p.rows; row += rows) {
    multiply_tile<T, rows, vectors>(p, p.a + row * p.a_row, p.b + column,
                                    p.c + row * p.c_row + column);
  }
  if constexpr (rows > 1) multiply_rows<T, vectors, rows - 1>(p, column, row);
}

/// Computes all rows of the tiles of `vectors` vectors that fit from `column` on. Returns the next
/// column.
template <class T, int vectors>
std::int64_t multiply_columns(const MatrixProduct<T>& p, std::int64_t column) {
  constexpr std::int64_t width = vectors * lanes<T>;
  for (; column + width <= p.columns; column += width) multiply_rows<T, vectors>(p, column);
  return column;
}

}  // namespace

template <class T>
void multiply(const MatrixProduct<T>& product) {
  std::int64_t column = multiply_columns<T, widest_tile>(product, 0);
  if constexpr (widest_tile > 2) column = multiply_columns<T, 2>(product, column);
  multiply_columns<T, 1>(product, column);
}

template void multiply(const MatrixProduct<float>&);
template void multiply(const MatrixProduct<double>&);

}  // namespace piae::nets

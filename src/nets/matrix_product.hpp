#pragma once

#include <cstdint>

namespace piae::nets {

/// A product of matrices summed over blocks: C = sum over b of A_b B_b. Numbers in a row of B_b
/// [depth, columns] and of C [rows, columns] are contiguous. A_b [rows, depth] may have any stride,
/// so it may be a transposed matrix, or one whose rows overlap. C must not overlap A or B.
/// `columns` must be a multiple of row_granule. This is a view: it does not own the arrays.
template <class T>
struct MatrixProduct {
  const T* a;
  std::int64_t a_row;     ///< distance from one row of A_b to the next
  std::int64_t a_column;  ///< distance from one column of A_b to the next
  const T* b;
  std::int64_t b_row;  ///< distance from one row of B_b to the next
  T* c;
  std::int64_t c_row;
  std::int64_t rows;
  std::int64_t columns;
  std::int64_t depth;
  std::int64_t blocks = 1;
  std::int64_t a_block = 0;  ///< distance from A_b to A_(b+1)
  std::int64_t b_block = 0;  ///< distance from B_b to B_(b+1)
  bool add = false;          ///< C += the sum, instead of C = the sum
};

/// Computes C. BLAS and Eigen first copy the matrices into another order. Our matrices are so
/// small, or have so few rows, that a copy would cost a fifth of the speed or more, so this
/// function reads them in place. Each number of C is summed in the same order for every shape, so
/// that the result of a window does not depend on its batch.
template <class T>
void multiply(const MatrixProduct<T>& product);

extern template void multiply(const MatrixProduct<float>&);
extern template void multiply(const MatrixProduct<double>&);

}  // namespace piae::nets

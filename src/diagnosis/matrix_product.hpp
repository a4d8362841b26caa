#pragma once

#include <cstdint>

namespace piae::diagnosis {

/// C = sum over b of A_b B_b. C [rows, columns] and every B_b [depth, columns] are row-major
/// without gaps; A_b [rows, depth] lies at any stride, and so may be a transposed matrix, or one
/// whose rows overlap. C must not overlap the others. `columns` is a multiple of row_granule.
template <class T>
struct MatrixProduct {
  const T* a;
  std::int64_t a_row;     ///< from one row of A_b to the next
  std::int64_t a_column;  ///< from one column of A_b to the next
  std::int64_t a_block;   ///< from A_b to A_(b+1)
  const T* b;
  std::int64_t b_block;  ///< from B_b to B_(b+1)
  T* c;
  std::int64_t rows;
  std::int64_t columns;
  std::int64_t depth;
  std::int64_t blocks = 1;
};

/// The matrices of WDCNN are so small that copying them into another order, as BLAS and Eigen do,
/// costs them a fifth of their speed; this reads them where they are. Each number of C is summed in
/// one order whatever the shape, so that a window's result does not depend on its batch.
template <class T>
void multiply(const MatrixProduct<T>& product);

extern template void multiply(const MatrixProduct<float>&);
extern template void multiply(const MatrixProduct<double>&);

}  // namespace piae::diagnosis

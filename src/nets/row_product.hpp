#pragma once

#include <cstdint>

namespace piae::nets {

/// A product of matrices C = A B. Rows of B [depth, columns] and of C [rows, columns] lie without
/// gaps between their numbers; A [rows, depth] may lie at any stride, so it may be a transposed
/// matrix. C must not overlap A or B. `columns` must be a multiple of row_granule. This is a view:
/// it owns none of the arrays.
template <class T>
struct RowProduct {
  const T* a;
  std::int64_t a_row;     ///< numbers from one row of A to the next
  std::int64_t a_column;  ///< numbers from one column of A to the next
  const T* b;
  std::int64_t b_row;  ///< numbers from one row of B to the next
  T* c;
  std::int64_t c_row;
  std::int64_t rows;
  std::int64_t columns;
  std::int64_t depth;
};

/// C = A B. Made for the few rows of a batch: B is read where it lies, once for up to
/// rows_at_a_time rows. What a row of C is does not depend on the rows beside it.
template <class T>
void set_product(const RowProduct<T>& product);

/// C += A B.
template <class T>
void add_product(const RowProduct<T>& product);

}  // namespace piae::nets

#pragma once

#include <cstdint>

namespace piae::nets {

/// A view of rows of numbers; row i starts at data + i * stride. Zeros pad each row to whole
/// vectors (base/vector.hpp), so the stride is a multiple of a vector.
template <class T>
struct Rows {
  T* data;
  std::int64_t stride;

  [[nodiscard]] T* row(std::int64_t i) const { return data + i * stride; }
  [[nodiscard]] Rows from(std::int64_t i) const { return {row(i), stride}; }
  operator Rows<const T>() const { return {data, stride}; }
};

/// A range of consecutive rows.
struct RowRange {
  std::int64_t begin;
  std::int64_t count;
};
inline constexpr RowRange no_rows{.begin = 0, .count = 0};

}  // namespace piae::nets

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "raw/variable_path.hpp"

namespace piae::raw {

using Shape = std::vector<std::size_t>;

/// Names a variable in an error.
struct Where {
  const std::filesystem::path& file;
  const char* noun;  ///< "variable", "dataset"
  std::string name;
};

/// An array of numbers that is read when it is asked for.
struct Array {
  Shape shape;
  bool is_column_major;  ///< the first index runs fastest, as in MATLAB; else the last one does
  std::function<std::vector<double>()> numbers;
};

/// Throws Error(bad_input) with "FILE: variable K.Y <what>".
[[noreturn]] void refuse(const Where& where, const std::string& what);

/// The product of the extents; the largest number where it is larger.
std::size_t count_of(const Shape& shape);

/// The number of values in an array of these extents. Throws Error(bad_input) where they are more
/// than the file can hold (limits.hpp).
std::size_t possible_count(const Where& where, const Shape& shape);

/// A vector, or a row or column of a matrix. Throws Error(bad_input) where the array is neither,
/// with a row or column of it that could be named.
std::vector<double> vector_of(const Where& where, const Array& array,
                              const std::optional<MatrixLine>& line);

}  // namespace piae::raw
